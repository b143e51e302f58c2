// Spacing of the distinct positions of a cloud, for work that has the cloud already.
#pragma once

#include "core/process/neighbours/knn.h"

#include <cmath>

namespace process {

/// Spacing over mean distance to the 6 nearest: sqrt(sqrt(3) / 2) = 0.9306 in a hexagonal layout (process/README 1.1).
constexpr double spacingOverDistance = 0.93;

/// Neighbours that spacing is made of.
constexpr std::size_t ringSize = 6;

/// Where the nearest others are at these squared distances, ascending, none of which counts for less than another.
/// REQUIRES: at least one.
inline float spacingOfRing(std::span<const float> distancesSq) {
    const std::size_t count = std::min(ringSize, distancesSq.size());
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k)
        sum += static_cast<double>(std::sqrt(distancesSq[k]));
    return static_cast<float>(spacingOverDistance * sum / static_cast<double>(count));
}

/// One per position; 0 where a position is the only one.
std::vector<float> spacingsOf(const Cloud& cloud, const base::Progress& progress = {});

} // namespace process
