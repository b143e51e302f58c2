// Elastic grab: pulls the surface as if it were part of an elastic solid: regularized Kelvinlets [Goes17].
//
//     p' = p + c(r) sum_k W_k K_{E_k}(p - centre) m / sum_k W_k K_{E_k}(0)       m = grip * strength * dab.move
//     K_E(d) = (a - b)/l I + b/l^3 d d^T + a/2 E^2/l^3 I,    l = sqrt(|d|^2 + E^2)          (eq. 6)
//     a = 1, b = a / (4 (1 - v))                            v: Poisson ratio; 1/2 keeps volume
//
// Three radii E, 1.1 E, 1.21 E with the weights 1, -(E3^2 - E1^2)/(E3^2 - E2^2), (E2^2 - E1^2)/(E3^2 - E2^2) make it
// fade as 1/|d|^5, the tri-scale form. E = softness * R. The solid would move everywhere a little; c, a
// smoothstep of the falloff from 0 to 1/4, lets it end at the brush's rim.
//
// A solid pulled far becomes a thread. Where that gets thinner than surfels can tell (|m|/w at its tip below 0.95)
// it slips: grip falls to 0 at 0.75.
//
// All derivatives are those of the formula. The ball travels with what it holds, as grab's.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow elasticGrabTool;

} // namespace sculpt
