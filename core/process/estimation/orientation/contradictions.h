// Whether the sides that normals tell agree: those of a file may look out here and in beside it.
#pragma once

#include "core/tree/surfel_tree.h"

namespace process {

/// Of pairs of neighbours in one sheet, how many have normals that look opposite ways; 0 to 1. What stands across a
/// thin wall is no neighbour. From up to 4096 surfels.
double contradictions(const tree::SurfelTree& tree);

} // namespace process
