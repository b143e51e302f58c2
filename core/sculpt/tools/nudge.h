// Nudge: pushes the surface along itself, the way the stroke goes; inverted, against it.
//
//     p' = p + strength * w(|p - centre| / R) * m        m = the part of dab.travel in the plane of areaNormal, |m| <=
//     0.3 R
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow nudgeTool;

} // namespace sculpt
