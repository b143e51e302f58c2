// Paint: colours the surface; inverted, with the second colour.
//
//     colour' = colour + |strength| w(|p - centre| / R) (1 - mask) (paint - colour)     each channel as stored
//
// Channels are bytes. What lies between two of them is rounded up or down by a hash of the surfel's place and the dab,
// in the right proportion, so that faint strokes build up instead of being lost. Nothing moves. The version's layout
// says from now on that its colours mean something; models that came without are white.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow paintTool;

} // namespace sculpt
