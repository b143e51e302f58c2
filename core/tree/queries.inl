// The template queries of SurfelTree: plain descents in tree order, and the front-to-back walk along a ray.
#pragma once

#include "core/tree/ray_queue.h"

namespace tree {

namespace detail {

/// Calls fn(lane) for the set bits, lowest first.
template <class Fn>
inline void forLanes(unsigned mask, const Fn& fn) {
    for (; mask != 0; mask &= mask - 1)
        fn(std::countr_zero(mask));
}

/// Visits the blocks below `node` that `select(lanes)` lets through on every level: fn(number, block).
template <class Select, class Fn>
void descend(const Node& node, std::uint32_t first, const Select& select, const Fn& fn) {
    forLanes(select(static_cast<const surfel::BoundsLanes&>(node)) & node.childMask(), [&](int i) {
        const std::uint32_t number = first + node.firstBlock[i];
        if (node.level == 1)
            fn(number, *node.blocks[i]);
        else
            descend(*node.nodes[i], number, select, fn);
    });
}

} // namespace detail

template <class Fn>
void SurfelTree::forEachBlock(const Fn& fn) const {
    if (m_root)
        detail::descend(
            *m_root, 0, [](const surfel::BoundsLanes&) { return ~0u; }, fn);
}

template <class Fn>
void SurfelTree::forClustersInSupport(const base::Vec3f& x, const Fn& fn, float reach) const {
    if (!m_root)
        return;
    const auto select = [&](const surfel::BoundsLanes& lanes) { return lanes.supporting(x, reach); };
    detail::descend(*m_root, 0, select, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        detail::forLanes(select(block.boundsLanes()), [&](int cluster) { fn(block, cluster); });
    });
}

template <class Fn>
void SurfelTree::forBlocksInSupport(const base::Box3f& box, const Fn& fn, float reach) const {
    if (m_root)
        detail::descend(
            *m_root, 0, [&](const surfel::BoundsLanes& lanes) { return lanes.supporting(box, reach); }, fn);
}

template <class Fn>
void SurfelTree::forClustersInSupport(const base::Box3f& box, const Fn& fn, float reach) const {
    forBlocksInSupport(
        box,
        [&](std::uint32_t, const surfel::SurfelBlock& block) {
            detail::forLanes(block.boundsLanes().supporting(box, reach), [&](int cluster) { fn(block, cluster); });
        },
        reach);
}

template <class Fn>
void SurfelTree::forBlocksInBall(const base::Vec3f& centre, float radius, const Fn& fn) const {
    if (m_root)
        detail::descend(
            *m_root, 0, [&](const surfel::BoundsLanes& lanes) { return lanes.within(centre, radius * radius); }, fn);
}

template <class Fn>
void SurfelTree::alongRay(const base::Rayf& ray, const Fn& fn) const {
    if (!m_root)
        return;
    const surfel::RaySlabs slabs(ray);
    RayQueue queue;
    float enter[fanOut], leave[fanOut];
    const auto openNode = [&](const Node& node) {
        detail::forLanes(node.meeting(slabs, enter, leave) & node.childMask(), [&](int i) {
            if (node.level == 1)
                queue.push({enter[i], leave[i], nullptr, node.blocks[i].get(), -1});
            else
                queue.push({enter[i], leave[i], node.nodes[i].get(), nullptr, -1});
        });
    };
    for (openNode(*m_root); !queue.empty();) {
        const RayQueue::Entry next = queue.pop();
        if (next.cluster >= 0) {
            if (!fn(*next.block, next.cluster, next.enter, next.leave))
                return;
        } else if (next.node) {
            openNode(*next.node);
        } else {
            const unsigned hit = next.block->boundsLanes().meeting(slabs, enter, leave);
            detail::forLanes(hit & next.block->clusterMask(), [&](int cluster) {
                queue.push({enter[cluster], leave[cluster], nullptr, next.block, cluster});
            });
        }
    }
}

} // namespace tree
