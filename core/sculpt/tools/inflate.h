// Inflate: pushes the surface out (inverted: in) along its own normals, so that what is under the brush swells.
//
//     p' = p + a(p) n(p),   a = strength * 0.05 R * w(|p - centre| / R)        F = I + n (grad a)^T + a grad n
//
// n is the normal of the model's own frame at p (surface/README 2.4), a smooth field whose gradient comes with it: the
// noise of single normals is not blown up, and curvature turns the carried normals as it must. Inverted, a place whose
// other side has come into its support goes a smaller part of its way and at last none: what is thin gets thinner and
// does not turn inside out.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow inflateTool;

} // namespace sculpt
