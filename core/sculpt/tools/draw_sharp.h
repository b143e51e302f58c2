// Draw sharp: cuts a groove with a sharp bottom (inverted: raises a ridge with a sharp crest) along the mean normal.
//
//     p' = p - strength * 0.1 R * w(r) (1 - r)^2 * areaNormal,    r = |p - centre| / R
//
// The factor (1 - r)^2 gives any falloff a tip: where Smooth is flat at the centre, the product has slope -2.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow drawSharpTool;

} // namespace sculpt
