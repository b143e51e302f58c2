// Grab: holds what was touched first and carries it with the pointer.
//
//     p' = p + m w(p),   w(p) = W(|(p + p')/2 - (centre + m/2)| / R)            m = strength * dab.move
//
// W is 1 within the plateau and fades from there to the rim: what is held moves rigidly, and a long pull leaves a horn
// instead of a thread (sculpt/README 6.2). The weight is taken half way, which makes a step its own inverse with
// -m: pulled out and pushed back the same way, the surface comes back. w is found by Newton's method; the stroke keeps
// steps at a tenth of the radius, where |m| W' / 2R is below 0.2 and w is unique. Differentiating the formula gives the
// exact Jacobian
//
//     F = I + m g^T,   g = k / (1 - k.m/2),   k = grad W at the half-way place
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow grabTool;

} // namespace sculpt
