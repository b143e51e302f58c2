// Removes triangles, and the vertices that nothing uses afterwards.
#pragma once

#include "core/mesh/finish/orient_mesh.h"

#include <functional>

namespace mesh {

/// Removes the triangles whose numbers `keep` rejects; returns how many. Vertices stay.
std::size_t keepTriangles(Mesh& mesh, const std::function<bool(std::size_t)>& keep);

/// Removes vertices that no triangle uses.
void dropUnused(Mesh& mesh);

/// Removes pieces of fewer than `least` triangles and the vertices that only they used (mesh/README 3.10).
void dropSmallPieces(Mesh& mesh, const Orientation& pieces, std::size_t least);

} // namespace mesh
