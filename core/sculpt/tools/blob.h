// Blob: raises a ball (inverted: a dent) by pushing out and spreading at once.
//
//     p' = p + w(|p - centre| / R) (strength * 0.05 R * areaNormal + |strength| * 0.1 magnify * t)
//
// t is the part of p - centre across the stroke, all of it in the brush's plane while there is no direction
// (gather_in.h).
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow blobTool;

} // namespace sculpt
