// Scrape: takes down what stands above the mean plane under the brush and leaves what lies below; inverted, fills.
//
//     p' = p - |strength| * 0.2 * w(|p - centre| / R) * s(x) * areaNormal      x, s: to_plane.h
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow scrapeTool;

} // namespace sculpt
