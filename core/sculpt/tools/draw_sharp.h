// Draw sharp: cuts a groove with a sharp bottom (inverted: raises a ridge with a sharp crest) along the mean normal.
//
//     p' = p - strength * 0.1 R * w(|p - centre| / R) (1 - v)^2 * areaNormal
//
// v is the distance from the stroke's line in radii: |across . (p - centre)| / R, across at right angles to the stroke
// in the plane of areaNormal; |p - centre| / R while the stroke has no direction. The factor gives any falloff an edge:
// the dabs of a stroke add up to a profile with slope at its middle, where those of round tips would add up to a round
// one.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow drawSharpTool;

} // namespace sculpt
