// Which way the triangles of a mesh face, and its connected pieces (RULES-4 B8).
//
// Triangles are joined across their edges, the flattest first, each with its turn relative to the piece that it joins;
// an edge that closes a way round the other way is a conflict: a mesh with conflicts has no two sides. Ways over flat
// edges are followed first, so that a conflict shows where the surface is least sure of itself.
#pragma once

#include "core/mesh/mesh.h"

namespace mesh {

struct Orientation {
    std::vector<std::uint32_t> pieceOf;    ///< for each triangle, numbered from 0 by their first triangles
    std::vector<std::uint32_t> pieceSizes; ///< in triangles
    std::size_t conflicts = 0;             ///< edges whose triangles run the same way along them
};

/// Turns triangles until as many as possible agree with their neighbours. A piece as a whole faces where its vertices'
/// normals point if `byNormals`, else outwards, judged by its volume; normals then follow the triangles.
/// REQUIRES: normals; edges with at most two triangles.
Orientation orient(Mesh& mesh, bool byNormals);

} // namespace mesh
