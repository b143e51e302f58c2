#include "core/surface/candidates.h"

#include <bit>
#include <limits>

namespace surface {

constexpr std::size_t lanes = 16, groupSize = 7 * lanes;

void Candidates::collect(const Surface& surface, const base::Box3f& box) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    m_box = box;
    m_bounds.clear();
    m_clusters.clear();
    const float reach = queryReach(surface.supportScale());
    surface.tree().forClustersInSupport(
        box,
        [&](const surfel::SurfelBlock& block, int cluster) {
            const std::size_t lane = m_clusters.size() % lanes;
            if (lane == 0) {
                m_bounds.resize(m_bounds.size() + groupSize);
                float* group = m_bounds.data() + m_bounds.size() - groupSize;
                std::fill_n(group, 3 * lanes, inf);
                std::fill_n(group + 3 * lanes, 3 * lanes, -inf);
                std::fill_n(group + 6 * lanes, lanes, 0.0f);
            }
            float* at = m_bounds.data() + m_bounds.size() - groupSize + lane;
            const surfel::ClusterBounds bounds = block.bounds(cluster);
            for (std::size_t k = 0; k < 3; ++k) {
                at[k * lanes] = bounds.box.lo[k];
                at[(3 + k) * lanes] = bounds.box.hi[k];
            }
            at[6 * lanes] = reach * bounds.maxSupport;
            m_clusters.push_back(block.channel(cluster, surfel::X));
        },
        reach);
}

void Candidates::select(const base::Vec3f& x, ClusterList& out) const {
    constexpr std::size_t atOnce = 64;
    std::uint16_t bits[atOnce];
    const std::size_t groups = m_bounds.size() / groupSize;
    for (std::size_t first = 0; first < groups; first += atOnce) {
        const std::size_t count = std::min(atOnce, groups - first);
        supportKernel(m_bounds.data() + first * groupSize, count, x, bits);
        for (std::size_t g = 0; g < count; ++g)
            for (unsigned left = bits[g]; left != 0; left &= left - 1)
                out.push_back(m_clusters[(first + g) * lanes + static_cast<std::size_t>(std::countr_zero(left))]);
    }
}

} // namespace surface
