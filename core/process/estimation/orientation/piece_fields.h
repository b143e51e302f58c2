// Pieces of a surface, each with signs that are certain in themselves, turned so that each lies in the field of the
// others as the surface of a body does (process/README 2.4). Inside this folder.
#pragma once

#include "core/base/disjoint_sets.h"
#include "core/process/neighbours/neighbour_table.h"

namespace process {

/// Signs of two points: equal, or opposite.
struct SignRelation {
    std::uint32_t a = 0, b = 0;
    bool opposite = false;
};

/// What fields say of those pieces about which they say enough. `pieces`: members in the order of the curve, the
/// largest piece first; `trees` join what is inside of them. In parallel, the same bits at any thread count. Throws
/// base::Cancelled.
std::vector<SignRelation> relationsOfPieces(const Cloud& cloud, const NeighbourTable& links,
                                            std::span<const base::Vec3f> normals,
                                            const std::vector<std::vector<std::uint32_t>>& pieces,
                                            base::ParitySets& trees, const base::Progress& progress = {});

/// How far winding numbers two spacings off the surface, on both sides, are from whole ones, with these signs: nothing
/// for bodies that are oriented, 0.25 for signs by chance and for sheets. Of up to 4000 points.
double farFromBodies(const Cloud& cloud, const NeighbourTable& links, std::span<const base::Vec3f> normals,
                     base::ParitySets& signs);

} // namespace process
