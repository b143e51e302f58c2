// Mask: protects what it is painted on from all tools but itself; inverted, frees it.
//
//     mask' = clamp(mask + strength * 0.5 w(|p - centre| / R), 0, 1)
//
// Nothing moves. The version's layout says from now on that its masks mean something.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow maskTool;

} // namespace sculpt
