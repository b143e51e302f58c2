// From facets of a triangulation to a mesh: manifold, on the surface to rounding, with sides, normals and attributes.
#pragma once

#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Takes triangles away until every edge has two at most, the smallest first, and gives every further fan at a vertex
/// a vertex of its own. Returns how many triangles that cost.
std::size_t makeManifold(Mesh& mesh);

/// Moves vertices of all kinds but Limit onto the surface as far as no triangle gets a smaller angle than `leastAngle`
/// (radians) by it, fills normals, and tells where at the boundary the surface's limit ends it and where it ends
/// otherwise.
void settleVertices(const surface::Surface& surface, double leastAngle, Mesh& mesh);

} // namespace mesh
