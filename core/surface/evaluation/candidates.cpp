#include "core/surface/evaluation/candidates.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace surface {

constexpr std::size_t lanes = 16, groupSize = 7 * lanes;

bool Candidates::walk(const tree::Node& node, const base::Box3f& box, std::size_t most) {
    for (unsigned left = node.supporting(box, m_reach) & node.childMask(); left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        if (node.level > 1) {
            if (!walk(*node.nodes[i], box, most))
                return false;
            continue;
        }
        if (m_blocks.size() == most)
            return false;
        const surfel::SurfelBlock* block = node.blocks[i].get();
        prefetch(block, sizeof(surfel::SurfelBlock));
        m_blocks.push_back(block);
        m_localSupport = std::min(m_localSupport, node.maxSupport[i]);
    }
    return true;
}

bool Candidates::findBlocks(const Surface& surface, const base::Box3f& box, std::size_t most) {
    m_reach = queryReach(surface.supportScale());
    m_localSupport = std::numeric_limits<float>::infinity();
    m_blocks.clear();
    const bool all = surface.tree().empty() || walk(*surface.tree().root(), box, most);
    m_box = all ? box : base::Box3f{};
    return all;
}

void Candidates::fetchClusters() {
    constexpr float inf = std::numeric_limits<float>::infinity();
    m_bounds.clear();
    m_clusters.clear();
    for (const surfel::SurfelBlock* block : m_blocks)
        for (unsigned left = block->boundsLanes().supporting(m_box, m_reach); left != 0; left &= left - 1)
            add(*block, std::countr_zero(left));
    for (std::size_t lane = m_clusters.size() % lanes; lane != 0 && lane < lanes; ++lane) {
        float* at = m_bounds.data() + m_bounds.size() - groupSize + lane;
        for (std::size_t k = 0; k < 3; ++k)
            at[k * lanes] = inf, at[(3 + k) * lanes] = -inf;
        at[6 * lanes] = 0;
    }
}

void Candidates::add(const surfel::SurfelBlock& block, int cluster) {
    const std::size_t lane = m_clusters.size() % lanes;
    if (lane == 0)
        m_bounds.resize(m_bounds.size() + groupSize);
    float* at = m_bounds.data() + m_bounds.size() - groupSize + lane;
    const surfel::BoundsLanes& bounds = block.boundsLanes();
    for (const float* row : {bounds.loX, bounds.loY, bounds.loZ, bounds.hiX, bounds.hiY, bounds.hiZ}) {
        *at = row[cluster];
        at += lanes;
    }
    *at = m_reach * bounds.maxSupport[cluster];
    const float* data = block.channel(cluster, surfel::X);
    prefetchCluster(data);
    m_clusters.push_back(data);
}

void Candidates::select(const base::Box3f& box, ClusterList& out) const {
    constexpr std::size_t atOnce = 64;
    std::uint16_t bits[atOnce];
    const std::size_t groups = m_bounds.size() / groupSize;
    for (std::size_t first = 0; first < groups; first += atOnce) {
        const std::size_t count = std::min(atOnce, groups - first);
        supportKernel(m_bounds.data() + first * groupSize, count, box, bits);
        for (std::size_t g = 0; g < count; ++g) {
            const float** to = out.roomFor(lanes);
            const float* const* from = m_clusters.data() + (first + g) * lanes;
            std::size_t found = 0;
            for (unsigned left = bits[g]; left != 0; left &= left - 1)
                to[found++] = from[std::countr_zero(left)];
            out.grown(found);
        }
    }
}

} // namespace surface
