// Pinch: draws the surface together under the brush, across the stroke; inverted, spreads it.
//
//     p' = p - strength * 0.1 * w(|p - centre| / R) * t       t = (across . (p - centre)) across
//
// across lies in the brush's plane at right angles to the stroke; where the stroke has no direction yet t is all of
// p - centre that lies in the plane. Nothing moves out of the plane. Where a fold closes (summed normals below 0.75 of
// the weights under the middle of the brush) pinching fades out and stops (sculpt/README 6.2): gather_in.h.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow pinchTool;

} // namespace sculpt
