// An inner node of the surfel tree: up to 8 children with their bounds in lanes, so that one vector test covers them
// all.
//
// Internal to the tree, visible because the queries are templates. Nodes of level 1 hold blocks, others hold nodes.
#pragma once

#include "core/surfel/surfel_block.h"

#include <array>

namespace tree {

constexpr int fanOut = 8;

struct Node;
using NodePtr = base::Pointer<const Node>;

struct alignas(64) Node : base::Shared {
    /// Bounds of the children; unused lanes hold empty boxes and support 0.
    float loX[fanOut], loY[fanOut], loZ[fanOut], hiX[fanOut], hiY[fanOut], hiZ[fanOut], maxSupport[fanOut];
    std::array<NodePtr, fanOut> nodes;           ///< level > 1
    std::array<surfel::BlockPtr, fanOut> blocks; ///< level == 1
    std::size_t surfelCount = 0;                 ///< below this node
    std::uint32_t blockCount = 0;                ///< below this node
    std::uint8_t level = 1;                      ///< 1 above the blocks
    std::uint8_t childCount = 0;

    static void destroy(const Node* node) { delete node; }
};

} // namespace tree
