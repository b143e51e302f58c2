// Twist: turns the surface about the mean normal through the first contact as the pointer turns about it.
//
//     p' = c + z N + Rot(phi) t,    phi = strength * dab.angle * w(|p - centre| / R), at most one radian a dab
//
// z and t are the parts of p - centre along and across N = areaNormal. Distances to the axis and to the centre stay, so
// that turns add up and turning back undoes them, whatever the falloff.
//
//     F = Rot(phi) + (N x Rot(phi) t) (grad phi)^T
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow twistTool;

} // namespace sculpt
