// Clay strips: lays flat strips with a square tip that points along the stroke, up to a plane above the surface.
//
//     p' = p + strength * 0.3 * S(p) * s(x) * areaNormal,      x and s as in clay: the distance below the plane
//     S  = B(|u| / 0.65 R) B(|v| / 0.65 R) T(w(r))             u along the stroke, v across, both in the brush's plane
//
// B falls from 1 to 0 over the last 0.4 of its way, T(w) = smoothstep(10 w) keeps of the falloff only that it ends at
// the brush's rim. Without a direction (a stroke's first dab) the tip is round: S = B(|t| / 0.65 R) T, t the part of
// p - centre in the plane. Inverted, the plane lies below and what stands above it is taken away.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow clayStripsTool;

} // namespace sculpt
