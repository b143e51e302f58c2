// Flatten: draws the surface under the brush to its mean plane, from both sides; inverted, deepens its relief.
//
//     p' = p - strength * 0.2 * w(|p - centre| / R) * x * areaNormal       x = height above the plane (to_plane.h)
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow flattenTool;

} // namespace sculpt
