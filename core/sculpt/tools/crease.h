// Crease: cuts a groove and draws its lips together (inverted: a ridge, drawn together as well).
//
//     p' = p + w(|p - centre| / R) (-strength * 0.05 R * areaNormal - |strength| * 0.1 pinch * t)
//
// t is what pinch moves: the part of p - centre across the stroke (gather_in.h). Drawing together stops by itself where
// the fold closes.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow creaseTool;

} // namespace sculpt
