// How far a mesh is from the surface it was made from: at its vertices and at the centres of its faces.
//
// Measured in float64 to the nearest point that an orthogonal projection finds, or, beyond the boundary, to the
// boundary (mesh/README 6.3). Same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

#include <span>

namespace mesh {

struct Deviation {
    std::size_t count = 0;
    std::size_t lost = 0; ///< of them, those without a nearby point of the surface; left out of the figures below
    double max = 0, hundredth = 0, median = 0; ///< the largest, what only one of a hundred exceeds, the middle
};

/// Infinity where there is no surface to be found.
double distanceTo(const surface::Surface& surface, const base::Vec3d& x, const surface::OrientationHint& hint);

/// Of the vertices that triangles use. Normals, where the mesh has them, tell near sheets apart.
Deviation vertexDeviation(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress = {});
/// Of the centres of all triangles.
Deviation faceDeviation(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress = {});

} // namespace mesh
