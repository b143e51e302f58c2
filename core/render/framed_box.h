// The part of a model that a view frames: all of it, unless a few surfels stand so far away that the rest would be a
// dot.
#pragma once

#include "core/tree/surfel_tree.h"

namespace render {

/// The model's bounds. Where these are more than twice as large as the box that leaves out a quarter of a percent of
/// the surfels at either end of each axis: the box of the surfels within and near that one. Cost: one pass over the
/// blocks, over the surfels where there are outliers.
base::Box3f framedBox(const tree::SurfelTree& tree);

} // namespace render
