// Draw: pushes the surface out (inverted: in) along the mean normal under the brush.
//
//     p' = p + strength * 0.05 R * w(|p - centre| / R) * areaNormal
//
// On a plane a dab leaves exactly the falloff's profile. A stroke with dabs every tenth of the radius passes over a
// point about ten times at half weight: at strength 1/2 it raises a ridge of a quarter of the radius, as Blender's.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow drawTool;

} // namespace sculpt
