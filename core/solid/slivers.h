// Faces that a seam leaves so narrow that no surfel stays on them (solid/README 2.3). Inside this room only.
#pragma once

#include "core/solid/seam_feet.h"
#include "core/tree/surfel_tree.h"

#include <vector>

namespace solid {

/// A surfel that is to come: as `like`, but there.
struct Sliver {
    base::Vec3d position, normal;
    tree::Neighbour like;
    std::uint32_t across; ///< the cell beside it, of the other version
};

/// Of a version and what stays of it outside of `other` (or `inside`): where the other version's surfels have feet on
/// the seam, and none of this one's own face does, places between the seam and the face's end. In the order of the
/// feet: the same at any thread count. `own`, `others`: feet of what stays, block by block.
std::vector<Sliver> sliversOf(const tree::SurfelTree& tree, const Side& side, const Side& other, bool inside,
                              const SeamFeet& own, const SeamFeet& others);

} // namespace solid
