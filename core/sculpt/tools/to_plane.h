// Moving the surface to a plane: what flatten, fill and scrape share.
//
//     x  = areaNormal . (p - areaCentre) - offset R           height above the plane
//     p' = p + pace w(|p - centre| / R) y(x) areaNormal       y = -x, or what lies on one side of the plane alone
//
// One side: y = s(-x) below the plane (Below), -s(x) above it (Above), s(x) = x^2 / (x + e) for x > 0, else 0. s is x
// but for a soft start (e = R / 64), so that no crease is left where the surface crosses the plane.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

enum class PlaneSide { Both, Below, Above };

/// `strength` < 0 moves away from the plane.
tree::Edit toPlane(const surface::Surface& version, const Dab& dab, PlaneSide side, float strength);

/// "offset", which the three tools have in common.
extern const std::span<const ToolParameter> planeParameters;

} // namespace sculpt
