// The part of a model that a view frames: all of it, unless a few surfels stand so far away that the rest would be a
// dot.
#pragma once

#include "core/tree/surfel_tree.h"

namespace render {

/// The model's bounds without what stands apart in small pieces: surfels in cells of 1/24 of the diagonal that touch
/// are one piece; pieces of at most a thousandth of the surfels, together at most half a percent, are left out where
/// they reach beyond the rest by more than a twentieth of its diagonal. Where the rest has less than a fifth of the
/// diagonal, pieces of a hundredth count as well, together at most three: a window in a room shows a street, too, but a
/// dot is no picture. Cost: a look at up to 65,536 surfels, and a pass over all where there are outliers.
base::Box3f framedBox(const tree::SurfelTree& tree);

} // namespace render
