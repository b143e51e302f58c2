// Which clusters to sum over: lists of pointers to their channels, in tree order. Internal to the room.
#pragma once

#include "core/surface/evaluation/moments.h"
#include "core/surface/surface.h"

#include <memory>

namespace surface {

/// Pointers to clusters. The first many live in the list itself, so that a list on the stack allocates nothing.
class ClusterList {
  public:
    ClusterList() = default;
    ClusterList(const ClusterList&) = delete;
    ClusterList& operator=(const ClusterList&) = delete;

    void push_back(const float* cluster) {
        if (m_size == m_capacity)
            grow();
        m_data[m_size++] = cluster;
    }
    /// Room for `count` more; what is written there counts once it is added by `grown`.
    const float** roomFor(std::size_t count) {
        while (m_size + count > m_capacity)
            grow();
        return m_data + m_size;
    }
    void grown(std::size_t count) { m_size += count; }
    void clear() { m_size = 0; }
    std::size_t size() const { return m_size; }
    ClusterSpan span() const { return {m_data, m_size}; }

  private:
    void grow();

    static constexpr std::size_t inlineCapacity = 96;
    const float* m_inline[inlineCapacity];
    std::unique_ptr<const float*[]> m_heap;
    const float** m_data = m_inline;
    std::size_t m_size = 0, m_capacity = inlineCapacity;
};

/// How far supports count in queries of the tree and of boxes: a little further than they reach, so that rounding in
/// the test of a box never loses a surfel that the kernel would find in support. Lists from different queries then
/// differ only in clusters without weight, and all give the same bits.
constexpr float queryReach(float scale) {
    return scale * 1.000001f;
}

/// Asks the processor for memory that will soon be read.
inline void prefetch([[maybe_unused]] const void* from, [[maybe_unused]] std::size_t bytes) {
#ifdef __GNUC__
    for (std::size_t at = 0; at < bytes; at += 64)
        __builtin_prefetch(static_cast<const char*>(from) + at);
#endif
}
/// The channels of a cluster that evaluations read.
inline void prefetchCluster(const float* cluster) {
    prefetch(cluster, (surfel::Support + 1) * surfel::clusterSize * sizeof(float));
}

/// Clusters that may have weight at x, supports multiplied by `scale`, appended. For double positions the box is
/// widened by its rounding; the weight itself decides.
void gather(const tree::SurfelTree& tree, const base::Vec3f& x, ClusterList& out, float scale = 1);
void gather(const tree::SurfelTree& tree, const base::Vec3d& x, ClusterList& out, float scale = 1);
/// The same somewhere in a box.
void gather(const tree::SurfelTree& tree, const base::Box3f& box, ClusterList& out, float scale = 1);

/// Such a list, for one position.
class ScratchClusters {
  public:
    ScratchClusters() = default;
    template <class T>
    ScratchClusters(const tree::SurfelTree& tree, const base::Vec3<T>& x, float scale = 1) {
        gather(tree, x, m_list, scale);
    }
    ClusterSpan span() const { return m_list.span(); }
    ClusterList& list() { return m_list; }

  private:
    ClusterList m_list;
};

/// Normal of the surfel with weight at x that is nearest in d^2 + 3 (n.q)^2, which prefers surfels beside x to those
/// above and below it (surface/README 2.7). Zero where there is none. Supports are multiplied by `scale`; `shape` is
/// the channel of their shapes, 0 for none.
base::Vec3d nearestNormal(ClusterSpan clusters, const base::Vec3d& x, double scale = 1, int shape = 0);

} // namespace surface
