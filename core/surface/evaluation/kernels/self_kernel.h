// The vectorised part of self-evaluation. Internal to the room.
#pragma once

#include "core/surface/evaluation/self.h"

namespace surface {

struct SelfInput {
    const float* cluster; ///< x[16] y[16] z[16] of the positions: those of a cluster's surfels, or any
    base::Box3f box;      ///< of their places
    ClusterSpan around;   ///< all clusters that may have weight in the box
    Weight weight;
    float scale, mu, boundaryLimit;
    float leastAgreement, leastSpread; ///< below these a surfel is special
    bool gradient;
    bool bend; ///< as well; REQUIRES: gradient
    int shape; ///< channel of shapes; 0: none
};

/// Rows that `selfKernel` picks into: the channels and 1 / h; for ellipsoids b and what the boundary limit counts of h.
constexpr std::size_t selfRows(bool shaped) {
    return surfel::Support + (shaped ? 6 : 2);
}

/// Evaluates at the 16 positions; returns a bit for each that is special, whose numbers are not to be used. `scratch`
/// has room for selfRows.
unsigned selfKernel(const SelfInput& in, float* scratch, SelfLanes& out);

} // namespace surface
