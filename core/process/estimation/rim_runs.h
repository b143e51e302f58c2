// Whether a model has a rim, decided from runs of neighbours along it (process/README 3), wherever they are: one sheet
// among a thousand solids is a sheet.
#pragma once

#include "core/process/estimation/rim_samples.h"

namespace process {

/// Whether somewhere 8 (1 + log10(n / 1000)) neighbours, at least 8 (of fewer than 64 surfels an eighth, at least 3),
/// lie at a rim side by side, and next to none of those beside them at the edge of something thin and closed
/// (closed_rims.h). `samples`: some of the surfels, by key; what stands around those that look as if they were at a rim
/// is looked at as far as a run needs it.
bool hasOpenRun(const surface::Surface& surface, std::span<const RimSample> samples, const base::Progress& progress);

} // namespace process
