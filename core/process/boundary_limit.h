// The off-centre limit that fits a model (alg. 6.2): 1.3 x the 99 % quantile of o over surfels whose neighbourhood is
// closed (no angular gap of 90 degrees among its tangent-plane neighbours), clipped to [0.15, 0.45] h; infinity where
// the model has no open neighbourhoods.
#pragma once

#include "core/surface/surface.h"

namespace process {

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress = {});

} // namespace process
