// Who stands beside whom, with the distance that is usual there: what makes places of any density comparable, and
// strays tell themselves apart (process/README 11.1).
#pragma once

#include "core/process/neighbours/knn.h"

#include <algorithm>

namespace process {

/// Every position's `count` nearest, whatever side they are on, and their distances.
struct NearestGraph {
    std::size_t count = 0;
    std::vector<std::uint32_t> index; ///< `count` in a row, nearest first
    std::vector<float> distance;
    std::size_t size() const { return count == 0 ? 0 : index.size() / count; }
    /// Whether j is among the nearest of i.
    bool sees(std::size_t i, std::uint32_t j) const {
        const auto begin = index.begin() + static_cast<std::ptrdiff_t>(i * count);
        const auto end = begin + static_cast<std::ptrdiff_t>(count);
        return std::find(begin, end, j) != end;
    }
};

/// Fewer where there are fewer.
NearestGraph nearestGraph(const Cloud& cloud, std::size_t count, const base::Progress& progress);

/// Neighbours of `i` among whose neighbours `i` is, nearest first; their places in the row of i. A stray sees the
/// model, nothing of the model sees it.
void mutualNeighbours(const NearestGraph& graph, std::size_t i, std::vector<std::uint32_t>& out);

/// Mean distance of up to 6 nearest mutual neighbours of each position; 0 where it has none.
std::vector<float> mutualSpacings(const NearestGraph& graph);

} // namespace process
