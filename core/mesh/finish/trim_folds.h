// Removes triangles where a mesh intersects itself near its boundary (mesh/README 3.9). Internal to the room.
//
// At folds sheets run into each other, and where the boundary comes close to itself, relaxation may push one part over
// the other. Triangles on the boundary are removed there, as long as the mesh stays manifold and keeps its topology:
// the surface ends there anyway, now slightly earlier.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

/// Reopens loops whose fan about one of the `middles` intersects other triangles. Removes those middles and marks the
/// vertices around them VertexKind::Fold again. `cell`: side of the cubes that the mesh was made with. Returns how
/// many. REQUIRES: kinds; a manifold mesh.
std::size_t reopenCut(Mesh& mesh, std::span<const std::uint32_t> middles, double cell);

/// Removes triangles on the boundary that intersect others or have no area, in a few rounds, and the vertices that only
/// they used. Returns how many triangles.
/// REQUIRES: as above.
std::size_t trimFolds(Mesh& mesh, double cell);

} // namespace mesh
