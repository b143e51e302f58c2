#include "core/surface/evaluation/free_space.h"

#include "core/surface/evaluation/kernels/free_space_kernel.h"

#include <bit>

namespace surface {

std::bitset<surfel::blockCapacity> FreeSpaceFinder::restless(const surfel::SurfelBlock& block,
                                                             const std::bitset<surfel::blockCapacity>& asked) {
    m_blocks.clear();
    const float reach = queryReach(m_query.ring + m_query.clear);
    m_tree.forBlocksInBall(block.box().centre(), 0.5f * block.box().diagonal() + reach,
                           [&](std::uint32_t, const surfel::SurfelBlock& near) { m_blocks.push_back(&near); });
    std::bitset<surfel::blockCapacity> out;
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
        const std::size_t first = static_cast<std::size_t>(cluster * surfel::clusterSize);
        constexpr std::bitset<surfel::blockCapacity> lanes((1u << surfel::clusterSize) - 1);
        if ((asked >> first & lanes).any())
            out |= std::bitset<surfel::blockCapacity>(look(block, cluster)) << first;
    }
    return out & asked;
}

unsigned FreeSpaceFinder::look(const surfel::SurfelBlock& block, int cluster) {
    const base::Box3f box = block.bounds(cluster).box;
    const float reach = queryReach(0.5f * box.diagonal() + m_query.ring + m_query.clear);
    m_near.clear();
    for (const surfel::SurfelBlock* near : m_blocks) {
        // a reach beyond floats lets lanes without a cluster in
        for (unsigned left = near->boundsLanes().within(box.centre(), reach * reach) & near->clusterMask(); left != 0;
             left &= left - 1)
            m_near.push_back(near->channel(std::countr_zero(left), surfel::X));
    }
    float* scratch = m_scratch.rows(freeSpaceRows, m_near.size());
    return freeSpaceKernel({block.channel(cluster, surfel::X), box, m_near.span(), m_query}, scratch);
}

} // namespace surface
