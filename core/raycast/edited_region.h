// Where an edit can have changed the surface: boxes about the surfels that one version has and the other has not, each
// as wide as those surfels' supports. Nothing outside them moved (alg. 2.1: there no weight changed).
#pragma once

#include "core/tree/surfel_tree.h"

namespace raycast {

/// A box for every cluster with such surfels, of either version. Cost follows what the versions do not share.
std::vector<base::Box3f> editedRegion(const tree::SurfelTree& from, const tree::SurfelTree& to);

} // namespace raycast
