// Signs s for which |A s - b|^2 is small: what A s comes nearest without the condition is rounded, then single signs
// turn as long as that makes it smaller, the one first that does most.
//
// For thousands of rows and columns, which take seconds: in parallel, by tiles, between which base::CancelScope is
// asked. The same bits at any thread count.
#pragma once

#include <span>
#include <vector>

namespace process {

/// `a`: column after column, each as long as b. Returns +-1 for every column. Throws base::Cancelled.
std::vector<double> nearestSigns(std::span<const double> a, std::span<const double> b);

} // namespace process
