// The free-space test (surface/README 8.4): a quick look around the surfels of a version, 16 at a time. Resampling asks
// it which surfels are worth a closer look: the restless ones, which are crowded or have free space beside them.
//
//     crowded   another surfel of its sheet is closer than `close`
//     free      in one of eight directions along the surface, at the distance `ring`, none is within `clear`
//
// A surfel is of the same sheet where the cosine between the normals is above `leastCosine`. The same bits on AVX2 and
// AVX-512.
#pragma once

#include "core/surface/evaluation/clusters.h"
#include "core/surface/evaluation/pick_scratch.h"

#include <bitset>

namespace surface {

struct FreeSpaceQuery {
    /// What says that two surfels are of one sheet: nothing, normals up to their sign, normals.
    enum class Sheets { All, Unsigned, Signed };
    float close = 0, ring = 0, clear = 0; ///< lengths > 0
    Sheets sheets = Sheets::Signed;
    float leastCosine = 0;
};

/// Looks at the surfels of one version's blocks. Used by one thread at a time; the tree must outlive it.
class FreeSpaceFinder {
  public:
    FreeSpaceFinder(const tree::SurfelTree& tree, const FreeSpaceQuery& query) : m_tree(tree), m_query(query) {}

    /// The surfels of a block of the tree, among those asked for, that are restless.
    std::bitset<surfel::blockCapacity> restless(const surfel::SurfelBlock& block,
                                                const std::bitset<surfel::blockCapacity>& asked);

  private:
    unsigned look(const surfel::SurfelBlock& block, int cluster);

    const tree::SurfelTree& m_tree;
    FreeSpaceQuery m_query;
    std::vector<const surfel::SurfelBlock*> m_blocks; ///< near the present block
    ClusterList m_near;
    PickScratch m_scratch;
};

} // namespace surface
