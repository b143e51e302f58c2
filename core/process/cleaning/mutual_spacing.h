// Who stands beside whom, with the distance that is usual there: what makes places of any density comparable, and
// strays tell themselves apart (process/README 11.1).
#pragma once

#include "core/process/estimation/neighbour_graph.h"

namespace process {

/// Every position's `count` nearest, whatever side they are on; fewer where there are fewer.
NeighbourGraph nearestGraph(const Cloud& cloud, std::size_t count, const base::Progress& progress);

/// Neighbours of `i` among whose neighbours `i` is, nearest first; their places in the row of i. A stray sees the
/// model, nothing of the model sees it.
void mutualNeighbours(const NeighbourGraph& graph, std::size_t i, std::vector<std::uint32_t>& out);

/// Mean distance of up to 6 nearest mutual neighbours of each position; 0 where it has none.
std::vector<float> mutualSpacings(const NeighbourGraph& graph);

} // namespace process
