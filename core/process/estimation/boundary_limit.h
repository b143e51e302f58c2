// The off-centre limit that fits a model (process/README 3): what one sample in 1e5 with a closed neighbourhood (no
// angular gap of 90 degrees among its tangent-plane neighbours) exceeds, from the 99 % quantile of o over them, clipped
// to [0.15, 0.45] h; infinity where the model has no rim: nowhere a run of neighbours (rim_runs.h) beside which o grows
// to 0.45 h, as it does at rims alone and on edges of thin solids, which are told from them (closed_rims.h). Up to
// 20000 surfels are looked at, evenly spread in tree order, and what stands around those that look as if they were at a
// rim. Points with unsampled parts have rims, even where the mesh that they come from closes them with large faces.
#pragma once

#include "core/surface/surface.h"

namespace process {

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress = {});

/// A surface of other surfels: where the definition leaves the limit to these, the one that fits them. A part has rims
/// that the whole has not.
surface::Surface withOwnLimit(tree::SurfelTree tree, surface::SurfaceDefinition definition,
                              const base::Progress& progress = {});

} // namespace process
