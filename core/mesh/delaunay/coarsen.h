// Removes as many vertices of a triangulation as the sizes asked for allow, before Delaunay refinement (mesh/README
// 4.3). Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/delaunay/kept_closed.h"

#include <functional>

namespace mesh {

using SizeField = std::function<double(const base::Vec3d&)>;

/// Collapses sides shorter than the local size while faces still face like the surface. Boundary loops keep their
/// course to within `distance`. First cuts off corners of the boundary, mostly at folds, that are too sharp to
/// triangulate well. With a `closed` one nothing of what it keeps changes. Throws base::Cancelled.
void coarsen(SurfaceTriangulation& mesh, const SizeField& size, double distance, const base::Progress& progress = {},
             KeptClosed* closed = nullptr);

} // namespace mesh
