// The vectorised part of self-evaluation. Internal to the room.
#pragma once

#include "core/surface/self.h"

namespace surface {

struct SelfInput {
    const float* cluster; ///< whose surfels are the positions
    base::Box3f box;      ///< of their places
    ClusterSpan around;   ///< all clusters that may have weight in the box
    Weight weight;
    float scale, mu, boundaryLimit;
    float leastAgreement, leastSpread; ///< below these a surfel is special
    bool gradient;
};

/// Floats of scratch that `selfKernel` needs for so many clusters around; 64-byte aligned.
constexpr std::size_t selfScratch(std::size_t clusters) {
    return 8 * (clusters + 1) * surfel::clusterSize;
}

/// Evaluates at the 16 surfels; returns a bit for each that is special, whose numbers are not to be used.
unsigned selfKernel(const SelfInput& in, float* scratch, SelfLanes& out);

} // namespace surface
