// Layer: raises the surface by a limited height; however often the stroke passes, the layer grows no thicker.
//
//     p' = p + H (P_k(q) - P_{k-1}(q)) N(q)         H = height * R, negative when inverted
//     P_k(q) = 1 - product over the stroke's dabs j <= k of (1 - |strength_j| w(|q - c_j| / R_j))
//
// q is the foot of p on the version that the stroke began on, N the unit gradient there, c_j the foot of dab j's
// centre. All dabs of a stroke together move a point by H P <= H along one line, and by the same as its neighbours:
// relief finer than the brush rides on top of the layer. With h the height of p over q and S the gradient of N,
//
//     F = I + N (B^T grad a)^T + a S B,     a = H (P_k - P_{k-1}),  B = dq/dp = (I + h S)^-1 (I - N N^T)
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow layerTool;

} // namespace sculpt
