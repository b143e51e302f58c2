// An inner node of the surfel tree: up to 8 children with their bounds in lanes, so that one vector test covers them
// all.
//
// Internal to the tree, visible because the queries are templates. Nodes of level 1 hold blocks, others hold nodes.
#pragma once

#include "core/surfel/surfel_block.h"

#include <array>
#include <bit>

namespace tree {

constexpr int fanOut = surfel::laneCount;

struct Node;
using NodePtr = base::Pointer<const Node>;

/// The lanes are the bounds of the children; unused lanes hold empty boxes and support 0.
struct alignas(64) Node : surfel::BoundsLanes, base::Shared {
    std::uint8_t level = 1; ///< 1 above the blocks
    std::uint8_t childCount = 0;
    std::uint32_t blockCount = 0;                ///< below this node
    std::size_t surfelCount = 0;                 ///< below this node
    std::uint32_t surfelsIn[fanOut] = {};        ///< below each child
    std::uint32_t firstBlock[fanOut] = {};       ///< number of each child's first block, counted from this node's first
    std::array<NodePtr, fanOut> nodes;           ///< level > 1
    std::array<surfel::BlockPtr, fanOut> blocks; ///< level == 1

    unsigned childMask() const { return (1u << childCount) - 1; }
    /// Number of blocks below a child.
    std::uint32_t blocksIn(int child) const {
        return (child + 1 < childCount ? firstBlock[child + 1] : blockCount) - firstBlock[child];
    }
    static void destroy(const Node* node) { delete node; }
};

} // namespace tree
