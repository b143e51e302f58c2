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
/// `pieces`: members in the order of the curve; `trees` join what is inside of them. The matrix has up to 4000 rows
/// and a column for each piece: not many more than a thousand should come. In parallel, the same bits at any thread
/// count. Throws base::Cancelled.
std::vector<SignRelation> signsByWinding(const Cloud& cloud, const NeighbourTable& links,
                                         std::span<const base::Vec3f> normals,
                                         const std::vector<std::vector<std::uint32_t>>& pieces, base::ParitySets& trees,
                                         const base::Progress& progress = {});

/// Which points have a surface in common: what neighbours that see each other join, by one of its points. Strays see a
/// surface that sees nothing of them.
std::vector<std::uint32_t> surfacesOf(const NeighbourTable& links, const base::Progress& progress = {});

/// What winding numbers say of the signs of a component, each of its surfaces by itself: they are 1/2 on bodies that
/// look outwards, -1/2 on such as look inwards.
struct WindingSide {
    std::vector<std::uint32_t> members; ///< in the order of the curve
    /// How far they are from that on average, whichever is nearer: nothing for bodies, 1/2 for planes, and where both
    /// sides of a thin body look the same way.
    double off = 0;
    bool inwards = false;
};

/// Of components with a surface of 50 points and more, by their roots in `signs`. Of up to 4000 points, 50 of a
/// surface.
std::map<std::uint32_t, WindingSide> windingSides(const Cloud& cloud, const NeighbourTable& links,
                                                  std::span<const base::Vec3f> normals,
                                                  std::span<const std::uint32_t> surfaceOf, base::ParitySets& signs,
                                                  const base::Progress& progress = {});

} // namespace process
