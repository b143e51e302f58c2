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

namespace detail {

/// Lanes of a mask by ascending entry; returns how many.
inline int byEntry(unsigned mask, const float (&enter)[fanOut], int (&order)[fanOut]) {
    int count = 0;
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        int at = count++;
        for (; at > 0 && enter[order[at - 1]] > enter[lane]; --at)
            order[at] = order[at - 1];
        order[at] = lane;
    }
    return count;
}

template <class Fn>
void nearRay(const Node& node, const surfel::RaySlabs& slabs, float& most, const Fn& fn) {
    float enter[fanOut], leave[fanOut];
    int order[fanOut];
    const int count = byEntry(node.meeting(slabs, enter, leave) & node.childMask(), enter, order);
    for (int k = 0; k < count && enter[order[k]] <= most; ++k) {
        if (node.level > 1) {
            nearRay(*node.nodes[order[k]], slabs, most, fn);
            continue;
        }
        const surfel::SurfelBlock& block = *node.blocks[order[k]];
        float begin[fanOut], end[fanOut];
        int clusters[fanOut];
        const int met = byEntry(block.boundsLanes().meeting(slabs, begin, end) & block.clusterMask(), begin, clusters);
        for (int c = 0; c < met && begin[clusters[c]] <= most; ++c)
            most = fn(block, clusters[c], begin[clusters[c]], end[clusters[c]]);
    }
}

} // namespace detail

template <class Fn>
void SurfelTree::nearRay(const base::Rayf& ray, const Fn& fn) const {
    float most = std::numeric_limits<float>::infinity();
    if (m_root)
        detail::nearRay(*m_root, surfel::RaySlabs(ray), most, fn);
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
                queue.push({enter[i], leave[i], nullptr, node.blocks[i].get(), -1, 0});
            else
                queue.push({enter[i], leave[i], node.nodes[i].get(), nullptr, -1, 0});
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
                queue.push({enter[cluster], leave[cluster], nullptr, next.block, cluster, 0});
            });
        }
    }
}

} // namespace tree
