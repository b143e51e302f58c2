// Edges of an inner wall, below those of the outer one (solid/README 4.2). Inside this room only.
#pragma once

#include "core/surface/surface.h"
#include "core/tree/surfel_tree.h"

namespace solid {

/// The model with its inner wall, `inner`, whose surfels have the model's layout. Where the model has labels, the wall
/// gets cells of its own, and sharp edges where it goes on from below one face of the model to below another. Surfels
/// of the model keep every bit. Throws base::Cancelled.
surface::Surface withInnerWall(const surface::Surface& model, surfel::SurfelList inner);

} // namespace solid
