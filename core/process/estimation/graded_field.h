// Grading: a field over positions in which neighbours differ by at most `slope` times their distance (process/README
// 1.3).
//
// The smallest such field above another one is the largest of all values lowered along ways, rounding included, so that
// it does not depend on the order in which it is found: threads share the work without waiting for each other.
#pragma once

#include "core/base/progress.h"
#include "core/process/neighbours/neighbour_graph.h"

namespace process {

/// The smallest graded field above `h`.
void raise(std::vector<float>& h, const NeighbourGraph& graph, float slope, const base::Progress& progress);

/// The mean of the smallest graded field above `h` and the largest below it: of all graded fields the one that departs
/// least from `h` (McShane and Whitney's extensions), unbiased where spacing is only noisy, and nowhere under half of
/// `h`, so that no place loses its cover.
void grade(std::vector<float>& h, const NeighbourGraph& graph, float slope, const base::Progress& progress);

} // namespace process
