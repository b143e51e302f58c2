// Clusters near a box with their bounds in lanes, so that many positions in the box share one walk of the tree.
//
// `select` gives the clusters in the order of the tree, as the tree's own query does: the bits of an evaluation do not
// depend on which of the two found them. Used by one thread at a time; its memory is kept between collections.
//
// Collecting takes two steps, each of which prefetches the memory that the next one reads, so that a caller that does
// each step for several boxes in turn waits for none of it.
#pragma once

#include "core/surface/evaluation/clusters.h"

#include <limits>
#include <vector>

namespace surface {

class Candidates {
  public:
    static constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

    /// All clusters that may have weight somewhere in `box`.
    void collect(const Surface& surface, const base::Box3f& box) {
        findBlocks(surface, box);
        fetchClusters();
    }
    /// The two steps of `collect`. The first gives up where more than `most` blocks lie about the box: false, and no
    /// position is covered until the next one.
    bool findBlocks(const Surface& surface, const base::Box3f& box, std::size_t most = anyNumber);
    void fetchClusters();
    /// Of the blocks found last, the least of their largest supports: the scale of what lies there. 0 for no block.
    float localSupport() const { return m_blocks.empty() ? 0.0f : m_localSupport; }

    bool covers(const base::Vec3f& x) const { return m_box.contains(x); }
    bool covers(const base::Box3f& box) const { return m_box.contains(box.lo) && m_box.contains(box.hi); }
    /// Those of them that may have weight at x. REQUIRES: covers(x).
    void select(const base::Vec3f& x, ClusterList& out) const { select(base::Box3f{x, x}, out); }
    /// Those of them that may have weight somewhere in `box`. REQUIRES: covers(box).
    void select(const base::Box3f& box, ClusterList& out) const;

  private:
    bool walk(const tree::Node& node, const base::Box3f& box, std::size_t most);
    void add(const surfel::SurfelBlock& block, int cluster);

    base::Box3f m_box;
    float m_reach = 1, m_localSupport = 0;
    std::vector<const surfel::SurfelBlock*> m_blocks;
    std::vector<float> m_bounds; ///< per group of 16: loX[16] loY loZ hiX hiY hiZ maxSupport, unused lanes empty
    std::vector<const float*> m_clusters;
};

/// One bit per candidate of `groups` groups of 16, set where it may have weight somewhere in `box`.
void supportKernel(const float* bounds, std::size_t groups, const base::Box3f& box, std::uint16_t* bits);

} // namespace surface
