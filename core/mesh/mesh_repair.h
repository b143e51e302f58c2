// What is done to a finished mesh on request: rims where the definition ends are closed, small pieces are left out
// (RULES-4 B9, B10).
#pragma once

#include "core/mesh/orient_mesh.h"

namespace mesh {

/// Closes every boundary loop of at most `longest` edges at which a vertex is of VertexKind::Fold by a fan around its
/// middle, which need not lie on the surface. The loop's vertices become Inner. Returns how many were closed.
/// REQUIRES: normals and kinds; a manifold mesh.
std::size_t closeFolds(Mesh& mesh, std::size_t longest);

/// Leaves out vertices that no triangle uses.
void dropUnused(Mesh& mesh);

/// Leaves out pieces of fewer than `least` triangles and the vertices that only they used.
void dropSmallPieces(Mesh& mesh, const Orientation& pieces, std::size_t least);

} // namespace mesh
