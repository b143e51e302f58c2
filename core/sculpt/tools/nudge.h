// Nudge: pushes the surface along itself, in the direction of the stroke; inverted, against it.
//
//     p' = p + strength * w(|p - centre| / R) * m     m = part of dab.travel in the plane of areaNormal, |m| <= 0.3 R
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow nudgeTool;

} // namespace sculpt
