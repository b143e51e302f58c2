// k nearest neighbours: depth first, nearest child first, with a bounded heap of the best so far.
#include "core/tree/nearest_order.h"
#include "core/tree/surfel_tree.h"

namespace tree {

namespace {

/// Order of the answer: by distance, ties by block and slot.
bool closer(const Neighbour& a, const Neighbour& b) {
    if (a.distanceSq != b.distanceSq)
        return a.distanceSq < b.distanceSq;
    return a.blockNumber != b.blockNumber ? a.blockNumber < b.blockNumber : a.slot < b.slot;
}

class Search {
  public:
    Search(const base::Vec3f& x, std::size_t k, float maxDistance, std::vector<Neighbour>& out)
        : m_x(x), m_k(k), m_limit(maxDistance * maxDistance), m_best(out) {}

    void visit(const Node& node, std::uint32_t first) {
        float distance[fanOut];
        node.distanceSq(m_x, distance);
        nearestFirst(distance, node.childCount, [&](int i) {
            const std::uint32_t number = first + node.firstBlock[i];
            if (node.level > 1)
                visit(*node.nodes[static_cast<std::size_t>(i)], number);
            else
                visit(*node.blocks[static_cast<std::size_t>(i)], number);
        });
    }

  private:
    void visit(const surfel::SurfelBlock& block, std::uint32_t number) {
        float distance[fanOut];
        block.boundsLanes().distanceSq(m_x, distance);
        nearestFirst(distance, block.clusterCount(), [&](int cluster) { scan(block, number, cluster); });
    }

    void scan(const surfel::SurfelBlock& block, std::uint32_t number, int cluster) {
        const float *x = block.channel(cluster, surfel::X), *y = block.channel(cluster, surfel::Y),
                    *z = block.channel(cluster, surfel::Z);
        float distanceSq[surfel::clusterSize];
        for (int lane = 0; lane < surfel::clusterSize; ++lane) {
            const float dx = x[lane] - m_x.x, dy = y[lane] - m_x.y, dz = z[lane] - m_x.z;
            distanceSq[lane] = dx * dx + dy * dy + dz * dz;
        }
        const int first = cluster * surfel::clusterSize;
        const int lanes = std::min(surfel::clusterSize, block.size() - first);
        for (int lane = 0; lane < lanes; ++lane)
            if (distanceSq[lane] < m_limit)
                offer({&block, number, first + lane, distanceSq[lane]});
    }

    void offer(const Neighbour& candidate) {
        if (m_best.size() == m_k) {
            if (!closer(candidate, m_best.front()))
                return;
            std::pop_heap(m_best.begin(), m_best.end(), closer);
            m_best.pop_back();
        }
        m_best.push_back(candidate);
        std::push_heap(m_best.begin(), m_best.end(), closer);
    }

    /// True when nothing at that distance can enter the answer; an equal distance may, by its block and slot.
    bool tooFar(float distanceSq) const {
        return distanceSq >= m_limit || (m_best.size() == m_k && distanceSq > m_best.front().distanceSq);
    }

    template <class Fn>
    void nearestFirst(const float (&distance)[fanOut], int count, const Fn& fn) const {
        int order[fanOut];
        nearestFirstOrder(distance, count, order);
        for (int i = 0; i < count && !tooFar(distance[order[i]]); ++i)
            fn(order[i]);
    }

    base::Vec3f m_x;
    std::size_t m_k;
    float m_limit;
    std::vector<Neighbour>& m_best;
};

} // namespace

void SurfelTree::nearest(const base::Vec3f& x, std::size_t k, std::vector<Neighbour>& out, float maxDistance) const {
    out.clear();
    if (!m_root || k == 0)
        return;
    Search(x, k, maxDistance, out).visit(*m_root, 0);
    std::sort_heap(out.begin(), out.end(), closer);
}

} // namespace tree
