// A set of surfels of one version, as tools gather what lies under a brush: per touched block a mask of slots.
//
// Block numbers belong to the version they were gathered from. A value; threads may read it freely.
#pragma once

#include "core/surfel/surfel_block.h"

#include <bitset>
#include <vector>

namespace tree {

struct SelectedBlock {
    std::uint32_t block = 0;                  ///< number of the block in its version
    std::bitset<surfel::blockCapacity> slots; ///< the surfels meant; bits past the block's size are clear
};

/// Ascending by block, no block twice, no block without a slot.
using Selection = std::vector<SelectedBlock>;

/// Number of surfels selected.
inline std::size_t sizeOf(const Selection& selection) {
    std::size_t sum = 0;
    for (const SelectedBlock& block : selection)
        sum += block.slots.count();
    return sum;
}

} // namespace tree
