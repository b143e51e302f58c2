// Which clusters to sum over: lists of pointers to their channels, in tree order. Internal to the room.
#pragma once

#include "core/surface/moments.h"
#include "core/tree/surfel_tree.h"

#include <vector>

namespace surface {

using ClusterList = std::vector<const float*>;

/// Clusters that may have weight at x, appended. The float query is exact for float positions; for double ones the box
/// is widened by its rounding, and the weight itself decides.
void gather(const tree::SurfelTree& tree, const base::Vec3f& x, ClusterList& out);
void gather(const tree::SurfelTree& tree, const base::Vec3d& x, ClusterList& out);

/// Such a list in memory that the thread keeps for the next one. Lists of one thread end in the reverse order.
class ScratchClusters {
  public:
    ScratchClusters();
    template <class T>
    ScratchClusters(const tree::SurfelTree& tree, const base::Vec3<T>& x) : ScratchClusters() {
        gather(tree, x, m_list);
    }
    ~ScratchClusters();
    ScratchClusters(const ScratchClusters&) = delete;
    ScratchClusters& operator=(const ScratchClusters&) = delete;

    ClusterSpan span() const { return m_list; }
    ClusterList& list() { return m_list; }

  private:
    ClusterList m_list;
};

/// Normal of the surfel with weight at x that is nearest in d^2 + 3 (n.q)^2, which prefers surfels beside x to those
/// above and below it (RESAMPLING 4). Zero where there is none.
base::Vec3d nearestNormal(ClusterSpan clusters, const base::Vec3d& x);

} // namespace surface
