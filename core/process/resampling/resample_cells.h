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

/// A whole model by cells: each by itself, open where it meets others, as `one` resamples it; what then lies across a
/// crease goes. `reach`: the spacing before or after, whichever is larger. Labels of new surfels are those of the
/// nearest before. Nothing where there are not several cells.
std::optional<ResampleResult>
resampleEachCell(const surface::Surface& surface, float reach, const base::Progress& progress,
                 const std::function<ResampleResult(const surface::Surface&, const base::Progress&)>& one);
/// Has the model several cells?
bool hasCells(const surface::Surface& surface);
/// Are all surfels in a ball of one cell, with the same one or none across the nearest crease?
bool oneCellAround(const surface::Surface& surface, const base::Vec3f& centre, float radius);

} // namespace process
