// Outliers: few sparse positions about a dense model, as scanners leave them. They see the model among their
// neighbours, but nothing of the model sees them. Graded like all others (process/README 1.3) their wide radii would be
// carried into the model and smooth its details away; instead they take the radii of what they stand beside.
#pragma once

#include "core/process/neighbours/neighbour_graph.h"

#include <algorithm>

namespace process {

struct Outliers {
    /// An outlier and what it sees beside its own group.
    struct Sight {
        std::uint32_t outlier, seen;
        std::uint32_t place; ///< in the outlier's row
    };
    std::vector<std::uint32_t> members; ///< group by group
    std::vector<std::size_t> ends;      ///< of groups, in members
    std::vector<Sight> sights;
};

/// Positions that may hang together as outliers.
struct SwarmLimit {
    double share = 0.05; ///< of all
    std::size_t count = 10000;

    std::size_t of(std::size_t all) const {
        return std::min(static_cast<std::size_t>(share * static_cast<double>(all)), count);
    }
};

/// Finds the outliers by the radii that positions want, and cuts their edges to it: there they become their own
/// neighbours, at no distance. Sparse parts of the model stay in it: they lie beside the dense ones, in their tangent
/// planes. The same at any thread count.
Outliers cutOutliers(NeighbourGraph& graph, std::span<const float> wanted, const SwarmLimit& limit = {});

/// No outlier wider than the least that it sees of the model and `slope` allows, nor than another one plus `slope`
/// times their distance.
void lowerOutliers(std::vector<float>& h, NeighbourGraph& graph, const Outliers& outliers, float slope);

} // namespace process
