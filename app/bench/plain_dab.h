// A dab as a stroke would make it in the middle of its way, for measuring tools one by one.
#pragma once

#include "core/sculpt/tool.h"

namespace bench {

/// At a surfel, half strong, with the tool's default parameters, carried on and turned by a tenth of the radius.
sculpt::Dab plainDab(const sculpt::ToolRow& row, const surfel::Surfel& at, float radius);

} // namespace bench
