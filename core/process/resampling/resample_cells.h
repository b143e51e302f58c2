// Resampling of models with cells (core/cells/labels.h): each cell by itself (process/README 4.9). Nothing repels,
// merges with or is born of surfels across a crease, nothing lands on the rounded surface that both sides make
// together, and what is born carries the label of its cell. Internal to resample.
#pragma once

#include "core/process/resampling/resample.h"

#include <optional>

namespace process {

/// As resample(version, touched, options); nothing where there are no cells, or only one about what was touched.
std::optional<tree::Edit> resampleByCells(const surface::Surface& version, const tree::Selection& touched,
                                          const ResampleOptions& options);

} // namespace process
