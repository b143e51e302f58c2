// Signs of pieces of a surface, each certain in itself, by winding numbers: those of a body are 1/2 on its surface
// (process/README 2.4, surface/README 11). Inside this folder.
#pragma once

#include "core/base/disjoint_sets.h"
#include "core/process/neighbours/neighbour_table.h"

#include <map>

namespace process {

/// Signs of two points: equal, or opposite.
struct SignRelation {
    std::uint32_t a = 0, b = 0;
    bool opposite = false;
};

/// The signs of the pieces, each to the first one, with which winding numbers on all of them are nearest to 1/2.
/// `pieces`: members in the order of the curve; `trees` join what is inside of them. The matrix has 4000 rows and a
/// column for each piece: at most a thousand should come. In parallel, the same bits at any thread count. Throws
/// base::Cancelled.
std::vector<SignRelation> signsByWinding(const Cloud& cloud, const NeighbourTable& links,
                                         std::span<const base::Vec3f> normals,
                                         const std::vector<std::vector<std::uint32_t>>& pieces, base::ParitySets& trees,
                                         const base::Progress& progress = {});

/// What winding numbers on the surface say of signs: they are 1/2 on bodies that look outwards, -1/2 inwards.
struct WindingSides {
    /// How far they are from that on average, the components free to look inwards: nothing for bodies, 1/2 for planes,
    /// and where both sides of a thin body look the same way.
    double off = 0;
    struct Component {
        double off = 0; ///< its own
        bool inwards = false;
    };
    std::map<std::uint32_t, Component> components; ///< those of some size, by their roots in `signs`
};

/// Of up to 4000 points.
WindingSides windingSides(const Cloud& cloud, const NeighbourTable& links, std::span<const base::Vec3f> normals,
                          base::ParitySets& signs);

} // namespace process
