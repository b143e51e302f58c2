// Points that are searched by place: a surfel tree in which each surfel knows its number in the list it was made of.
//
// Const functions may run on any thread. The same bits at any thread count.
#pragma once

#include "core/surfel/shape.h"
#include "core/tree/surfel_tree.h"

#include <span>

namespace reduce {

class NumberedTree {
  public:
    NumberedTree() = default;
    /// `support`: the reach of each; empty: none is asked for. `shape`: of the supports; empty: balls. REQUIRES: lists
    /// of equal length.
    NumberedTree(std::span<const base::Vec3f> position, std::span<const base::Vec3f> normal,
                 std::span<const float> support, std::span<const base::Vec3f> shape = {});

    const tree::SurfelTree& tree() const { return m_tree; }
    static std::uint32_t number(const surfel::SurfelBlock& block, int slot) {
        return block.words(slot / surfel::clusterSize, surfel::Extra)[slot % surfel::clusterSize];
    }
    static std::uint32_t number(const tree::Neighbour& n) { return number(*n.block, n.slot); }

    /// fn(number, squared distance) for every point in whose support `x` lies, in tree order; distances are those of
    /// its shape.
    template <class Fn>
    void forSupporting(const base::Vec3f& x, const Fn& fn) const;
    /// fn(number, squared distance) for every point closer than `radius`, in tree order.
    template <class Fn>
    void forBall(const base::Vec3f& x, float radius, const Fn& fn) const;

  private:
    tree::SurfelTree m_tree;
    int m_shape = 0; ///< channel of shapes; 0: balls
};

template <class Fn>
void NumberedTree::forSupporting(const base::Vec3f& x, const Fn& fn) const {
    m_tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
        for (int slot = begin; slot < end; ++slot) {
            float distanceSq = base::distanceSq(block.position(slot), x);
            const float reach = block.support(slot);
            if (m_shape > 0)
                distanceSq = surfel::shapedSq(x - block.position(slot), surfel::shapeOf(block, slot, m_shape));
            if (distanceSq < reach * reach)
                fn(number(block, slot), distanceSq);
        }
    });
}

template <class Fn>
void NumberedTree::forBall(const base::Vec3f& x, float radius, const Fn& fn) const {
    m_tree.forBlocksInBall(x, radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
            if (block.bounds(cluster).box.distanceSq(x) >= radius * radius)
                continue;
            const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
            for (int slot = begin; slot < end; ++slot)
                if (const float distanceSq = base::distanceSq(block.position(slot), x); distanceSq < radius * radius)
                    fn(number(block, slot), distanceSq);
        }
    });
}

} // namespace reduce
