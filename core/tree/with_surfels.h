// A tree whose surfels say something else, place for place: other words, another layout.
#pragma once

#include "core/tree/surfel_tree.h"

namespace tree {

/// The same blocks with other surfels: as many, in the tree's order, place for place; their layout may be another one.
SurfelTree withSurfels(const SurfelTree& tree, const surfel::SurfelList& surfels);

} // namespace tree
