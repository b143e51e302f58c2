// Clusters near a box with their bounds in lanes, so that many positions in the box share one walk of the tree.
//
// `select` gives the clusters in the order of the tree, as the tree's own query does: the bits of an evaluation do not
// depend on which of the two found them. Used by one thread at a time; its memory is kept between collections.
//
// Collecting is done in two steps, each of which asks the processor for the memory that the next one will read, so that
// whoever does each step for several boxes in turn waits for none of it.
#pragma once

#include "core/surface/evaluation/clusters.h"

#include <vector>

namespace surface {

class Candidates {
  public:
    /// All clusters that may have weight somewhere in `box`.
    void collect(const Surface& surface, const base::Box3f& box) {
        findBlocks(surface, box);
        fetchClusters();
    }
    /// The two steps of `collect`.
    void findBlocks(const Surface& surface, const base::Box3f& box);
    void fetchClusters();

    bool covers(const base::Vec3f& x) const { return m_box.contains(x); }
    bool covers(const base::Box3f& box) const { return m_box.contains(box.lo) && m_box.contains(box.hi); }
    /// Those of them that may have weight at x. REQUIRES: covers(x).
    void select(const base::Vec3f& x, ClusterList& out) const { select(base::Box3f{x, x}, out); }
    /// Those of them that may have weight somewhere in `box`. REQUIRES: covers(box).
    void select(const base::Box3f& box, ClusterList& out) const;

  private:
    void add(const surfel::SurfelBlock& block, int cluster);

    base::Box3f m_box;
    float m_reach = 1;
    std::vector<const surfel::SurfelBlock*> m_blocks;
    std::vector<float> m_bounds; ///< per group of 16: loX[16] loY loZ hiX hiY hiZ maxSupport, unused lanes empty
    std::vector<const float*> m_clusters;
};

/// One bit per candidate of `groups` groups of 16, set where it may have weight somewhere in `box`.
void supportKernel(const float* bounds, std::size_t groups, const base::Box3f& box, std::uint16_t* bits);

} // namespace surface
