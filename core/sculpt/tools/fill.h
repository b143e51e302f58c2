// Fill: raises what lies below the mean plane under the brush and leaves what stands above it; inverted, scrapes.
//
//     p' = p + |strength| * 0.2 * w(|p - centre| / R) * s(-x) * areaNormal     x, s: to_plane.h
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow fillTool;

} // namespace sculpt
