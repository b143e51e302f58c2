#include "core/surface/evaluation/clusters.h"

namespace surface {

void ClusterList::grow() {
    auto larger = std::make_unique<const float*[]>(2 * m_capacity);
    std::copy_n(m_data, m_size, larger.get());
    m_heap = std::move(larger);
    m_data = m_heap.get();
    m_capacity *= 2;
}

/// At a position or in a box.
template <class Where>
static void gatherAt(const tree::SurfelTree& tree, const Where& where, ClusterList& out, float scale) {
    tree.forClustersInSupport(
        where,
        [&](const surfel::SurfelBlock& block, int cluster) {
            const float* data = block.channel(cluster, surfel::X);
            prefetchCluster(data);
            out.push_back(data);
        },
        queryReach(scale));
}

void gather(const tree::SurfelTree& tree, const base::Vec3f& x, ClusterList& out, float scale) {
    gatherAt(tree, x, out, scale);
}

void gather(const tree::SurfelTree& tree, const base::Box3f& box, ClusterList& out, float scale) {
    gatherAt(tree, box, out, scale);
}

void gather(const tree::SurfelTree& tree, const base::Vec3d& x, ClusterList& out, float scale) {
    const base::Vec3f nearest = base::cast<float>(x);
    const float size = std::max({std::abs(nearest.x), std::abs(nearest.y), std::abs(nearest.z)});
    const base::Box3f box = base::Box3f{nearest, nearest}.inflated(1e-6f * size);
    tree.forClustersInSupport(
        box, [&](const surfel::SurfelBlock& block, int cluster) { out.push_back(block.channel(cluster, surfel::X)); },
        queryReach(queryReach(scale)));
}

base::Vec3d nearestNormal(ClusterSpan clusters, const base::Vec3d& x, double scale, int shape) {
    constexpr int lanes = surfel::clusterSize;
    base::Vec3d best;
    double least = std::numeric_limits<double>::infinity();
    for (const float* c : clusters)
        for (int i = 0; i < lanes; ++i) {
            const double h = scale * static_cast<double>(c[surfel::Support * lanes + i]);
            const base::Vec3d q = base::Vec3d{c[i], c[lanes + i], c[2 * lanes + i]} - x;
            const base::Vec3d n{c[surfel::NormalX * lanes + i], c[surfel::NormalY * lanes + i],
                                c[surfel::NormalZ * lanes + i]};
            const double height = dot(n, q), metric = lengthSq(q) + 3 * height * height;
            double distanceSq = lengthSq(q);
            if (shape > 0) {
                const float* b = c + shape * lanes + i;
                const double along = dot(base::Vec3d{b[0], b[lanes], b[2 * lanes]}, q);
                distanceSq += along * along;
            }
            if (distanceSq < h * h && metric < least) {
                least = metric;
                best = n;
            }
        }
    return best;
}

} // namespace surface
