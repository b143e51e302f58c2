// Spacing of the distinct positions of a cloud, for work that has the cloud already.
#pragma once

#include "core/process/estimation/knn.h"

namespace process {

/// Spacing over mean distance to the 6 nearest: sqrt(sqrt(3) / 2) = 0.9306 in a hexagonal layout (process/README 1.1).
constexpr double spacingOverDistance = 0.93;

/// One per position; 0 where a position is the only one.
std::vector<float> spacingsOf(const Cloud& cloud, const base::Progress& progress = {});

} // namespace process
