// Snake hook: pulls a piece of the surface out into a horn that follows the pointer.
//
//     p' = p + m w(p) - taper |m|/R W(|p - centre| / R) t       m = strength * dab.move,  w as in grab (pull.h)
//
// t is the part of p - centre at right angles to m: the horn grows thinner (taper > 0) or thicker (< 0) on its way. A
// wide plateau keeps a long horn thick enough to be well sampled (sculpt/README 6.2).
//
//     F = I + m g^T - taper |m|/R (t (grad W)^T + W (I - u u^T)),     u = m / |m|
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow snakeHookTool;

} // namespace sculpt
