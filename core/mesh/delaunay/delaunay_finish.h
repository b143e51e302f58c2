// From refined faces to a mesh: on the surface to rounding, without what a demand forbids (mesh/README 4.6). Internal
// to the room.
#pragma once

#include "core/mesh/finish/orient_mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Moves all vertices but Limit ones onto their sheets unless that leaves a triangle with an angle below `leastAngle`
/// (radians); normals become unit gradients. REQUIRES: normals near to those.
void settleVertices(const surface::Surface& surface, double leastAngle, Mesh& mesh);

/// Removes triangles whose centre is further than `farthest` from the surface, or a corner further than a tenth of it,
/// as the validator measures (deviation.h); returns how many.
std::size_t leaveOutFar(const surface::Surface& surface, double farthest, Mesh& mesh);

/// Fills in kinds: does the boundary follow the surface's limit at a vertex, or not? Limit stays Limit.
void tellBoundaryKinds(const surface::Surface& surface, Mesh& mesh);

} // namespace mesh
