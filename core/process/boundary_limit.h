// The off-centre limit that fits a model (alg. 6.2): 1.3 x the 99 % quantile of o over surfels whose neighbourhood is
// closed (no angular gap of 90 degrees among its tangent-plane neighbours), clipped to [0.15, 0.45] h; infinity where
// the model has no rim: too few neighbourhoods that are open by 150 degrees with o beyond 0.12 h. Up to 20000 surfels
// are looked at, evenly spread in tree order.
#pragma once

#include "core/surface/surface.h"

namespace process {

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress = {});

} // namespace process
