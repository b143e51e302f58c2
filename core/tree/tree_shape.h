// How a version's surfels are spread over blocks and nodes: all of a tree that its list of surfels does not tell. Sums
// over surfels have their last bits from it (tree/README 5), so that a file that keeps it goes on as if it had never
// been closed.
//
// A shape that comes from a file is a claim: SurfelTree::build takes it only where it fits the surfels in every way.
#pragma once

#include "core/base/hash.h"

#include <cstdint>
#include <vector>

namespace tree {

struct TreeShape {
    std::vector<std::uint8_t> blocks; ///< surfels of each, in tree order
    std::vector<std::uint8_t> nodes;  ///< children of each: of the root, then level by level, each in tree order
    base::Hash128 check;              ///< of the blocks: the content of each, in their order

    bool empty() const { return blocks.empty(); }
    bool operator==(const TreeShape&) const = default;
};

} // namespace tree
