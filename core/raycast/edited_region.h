// Where an edit can have changed the surface: boxes about the surfels that only one of two versions has, each as wide
// as those surfels' supports. Outside them no weight changed, so nothing moved (raycast/README 3.3).
#pragma once

#include "core/tree/surfel_tree.h"

namespace raycast {

/// A box for every cluster of either version with such surfels. Costs as much as the versions do not share.
std::vector<base::Box3f> editedRegion(const tree::SurfelTree& from, const tree::SurfelTree& to);

} // namespace raycast
