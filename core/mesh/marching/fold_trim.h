// Where a mesh cuts itself beside its rims: the triangles that are left out (RULES-4 B9). Internal to the room.
//
// At folds sheets run into each other, and where a rim comes close to itself shaping may lay one part over the other.
// Triangles on the boundary go there, as long as the mesh stays manifold, of the same topology: the surface ends there
// anyway, a little earlier then.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

/// Opens loops again whose fan around one of the `middles` cuts other triangles. Leaves out the middles' vertices; what
/// is around them is VertexKind::Fold again. `cell`: of the cubes that the mesh was made with. Returns how many.
/// REQUIRES: kinds; a manifold mesh.
std::size_t reopenCut(Mesh& mesh, std::span<const std::uint32_t> middles, double cell);

/// Leaves out triangles on the boundary that cut others or have no area, in a few rounds, and the vertices that only
/// they used. Returns how many.
/// REQUIRES: as above.
std::size_t trimFolds(Mesh& mesh, double cell);

} // namespace mesh
