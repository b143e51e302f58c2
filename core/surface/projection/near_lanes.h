// Surfels near 16 positions, each with those of its own: picked once and kept while it stays near. Surfels out of reach
// add exact zeros to its sums, in the order of the tree, so that it has the same bits wherever they were picked.
// Internal to the room.
#pragma once

#include "core/surface/evaluation/clusters.h"

namespace surface {

/// First lane by lane, then turned so that the lanes stand side by side.
struct NearLanes {
    static constexpr std::size_t lanes = surfel::clusterSize;
    static constexpr std::size_t rows = surfel::Support + 2; ///< the channels and 1 / h
    static constexpr std::size_t capacity = 128;             ///< surfels of a lane
    static constexpr std::size_t stride = capacity + lanes;  ///< a packed store may write a cluster behind them

    alignas(64) float picked[lanes][rows][stride];
    alignas(64) float turned[capacity][rows][lanes];
    std::size_t counts[lanes] = {};
    std::size_t count = 0; ///< the most of them, rounded up to a multiple of 4
};

/// Takes the surfels whose supports, times `scale`, come within `slack` of x; false where there are too many.
bool pickNear(ClusterSpan clusters, const base::Vec3f& x, float scale, float slack, std::size_t lane, NearLanes& out);
/// Turns what the first `used` lanes hold; the others get anything. `reach[lane]`: a distance from `around[.][lane]`
/// that the lane's position stays within.
void turnNear(const float (&around)[3][NearLanes::lanes], const float (&reach)[NearLanes::lanes], std::size_t used,
              NearLanes& near);

} // namespace surface
