// Clay: builds up towards a plane above the surface, filling hollows before it raises heights.
//
//     x  = plane height - areaNormal . (p - areaCentre)              how far below the plane, plane height = offset * R
//     p' = p + strength * 0.2 * w(|p - centre| / R) * s(x) * areaNormal,    s(x) = x^2 / (x + e) for x > 0, else 0
//
// Inverted, the plane lies below and what stands above it is taken away. s is x but for a soft start (e = R / 16), so
// that no crease is left where the surface crosses the plane. A point never passes the plane: 0.2 w s(x) < x.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow clayTool;

} // namespace sculpt
