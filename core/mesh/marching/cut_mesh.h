// Cuts cubes and fills them: the triangles before they are oriented and shaped. Internal to the room.
#pragma once

#include "core/mesh/marching/marching_cubes.h"
#include "core/mesh/surface_traits.h"

namespace mesh {

/// Closed only where a solid is asked for.
SurfaceTraits solidTraits(const surface::Surface& surface, const MarchingOptions& options);

/// Triangles as cubes make them, each loop facing as its normals do. Cubes are of one size, or as large as surfels are
/// apart where that varies and no size is asked for.
Mesh cutMesh(const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
             const base::Progress& progress);

} // namespace mesh
