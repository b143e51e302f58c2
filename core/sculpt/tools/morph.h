// Morph: brings the surface back to what it was when the layer that strokes act on began, or inverted away from it.
//
//     p' = p + t (p_0 - p)      n' = normalise((1 - t) n + t n_0)      h' = h + t (h_0 - h)
//     t = strength w(|p - c| / R)
//
// p_0, n_0, h_0: where the surfel would be shown if that layer had strength 0 (layers/README 2). So a layer is a stored
// shape, and this brushes back towards it; as layers are carried by resampling, saved and undone, so is the shape.
// Without a layer to act on there is none, and nothing moves.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow morphTool;

} // namespace sculpt
