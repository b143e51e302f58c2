// The surfels under a brush as a list, for tools that ask the surface about each of them in one batch.
#pragma once

#include "core/sculpt/tools/brush.h"

#include <algorithm>

namespace sculpt {

struct Gathered {
    std::vector<base::Vec3f> places;
    std::vector<float> weight;      ///< of each: falloff and factors
    std::vector<float> free;        ///< 1 - mask
    std::vector<int> slots;         ///< in its block
    std::vector<std::size_t> first; ///< of each block, and the end

    /// Calls fn(i, lane) for those of one cluster of the block with that index.
    template <class Fn>
    void forCluster(std::size_t block, int cluster, const Fn& fn) const {
        const auto begin = slots.begin() + static_cast<std::ptrdiff_t>(first[block]);
        const auto end = slots.begin() + static_cast<std::ptrdiff_t>(first[block + 1]);
        const int from = cluster * surfel::clusterSize;
        for (auto at = std::lower_bound(begin, end, from); at != end && *at < from + surfel::clusterSize; ++at)
            fn(static_cast<std::size_t>(at - slots.begin()), static_cast<std::size_t>(*at - from));
    }
};

/// Those with a weight above 0 that are not fully masked, in tree order.
Gathered gather(const std::vector<BrushBlock>& blocks, const Brush& brush);

} // namespace sculpt
