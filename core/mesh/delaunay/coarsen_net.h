// Leaves as few vertices of a net as sizes allow: what Delaunay refinement begins with. Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/delaunay/surface_net.h"

#include <functional>

namespace mesh {

using SizeField = std::function<double(const base::Vec3d&)>;

/// Collapses sides shorter than the size about them as long as faces keep facing like the surface. Rims keep their
/// course to `distance`. Corners of rims too sharp to be triangulated well, of folds mostly, are cut off before.
/// Throws base::Cancelled.
void coarsen(SurfaceNet& net, const SizeField& size, double distance, const base::Progress& progress = {});

} // namespace mesh
