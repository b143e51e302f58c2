// One search for neighbours, and all that estimation takes from it: each position's 12 nearest, what duplicates are
// told by, and normals where they are wanted (process/README 1.6).
#pragma once

#include "core/process/estimation/neighbour_table.h"

namespace process {

struct CloudNeighbours {
    NeighbourTable table;
    base::LargeArray<float> spacing;        ///< as spacingsOf, the distances rounded first
    base::LargeArray<std::uint8_t> doubles; ///< how many of the nearest are one place with each (duplicates.h)
    std::vector<float> closestPile;         ///< of each cell: least squared distance to a (leastPile - 1)th neighbour
    base::LargeArray<base::Vec3f> normals;  ///< as normalsOf; empty unless asked for
};

/// `normalNeighbours`: that normals are estimated from; 0 for none.
CloudNeighbours neighboursOf(const Cloud& cloud, std::size_t normalNeighbours, const base::Progress& progress);

} // namespace process
