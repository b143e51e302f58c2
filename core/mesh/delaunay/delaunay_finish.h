// From a net's faces to a mesh: on the surface to rounding, manifold, without what a demand forbids. Internal to the
// room.
#pragma once

#include "core/mesh/orient_mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Moves vertices of all kinds but Limit onto their sheets as far as no triangle gets a smaller angle than `leastAngle`
/// (radians) by it; normals become unit gradients. REQUIRES: normals near to those.
void settleVertices(const surface::Surface& surface, double leastAngle, Mesh& mesh);

/// Leaves out triangles whose centres are further than `farthest` from the surface or a corner than a tenth of it, as
/// the validator measures (deviation.h); returns how many.
std::size_t leaveOutFar(const surface::Surface& surface, double farthest, Mesh& mesh);

/// Takes triangles away until every edge has two at most, the smallest first, and gives every further fan at a vertex
/// a vertex of its own. Returns how many triangles that cost.
std::size_t makeManifold(Mesh& mesh);

/// Fills kinds: where at the boundary the surface's limit ends it, and where it ends otherwise. Limit stays Limit.
void tellRims(const surface::Surface& surface, Mesh& mesh);

/// Leaves out pieces of a few triangles that end at folds; returns how many triangles. `pieces` does not fit any more.
std::size_t dropCrumbs(Mesh& mesh, const Orientation& pieces);

} // namespace mesh
