// Orients the triangles of a mesh and finds its connected pieces (mesh/README 3.8).
//
// Joins triangles across their edges, the flattest edges first, and records for each whether it has to be turned over
// to agree with its piece. An edge that closes a cycle and contradicts it is a conflict: a mesh with conflicts is
// one-sided. Following flat edges first puts conflicts where the surface is least certain.
#pragma once

#include "core/mesh/mesh.h"

namespace mesh {

struct Orientation {
    std::vector<std::uint32_t> pieceOf;    ///< by triangle; numbered from 0 in the order of first triangles
    std::vector<std::uint32_t> pieceSizes; ///< in triangles
    std::size_t conflicts = 0;             ///< edges whose triangles run the same way along them
};

/// Turns triangles over so that as many as possible agree with their neighbours. Each piece then faces along its vertex
/// normals if `byNormals`; otherwise outwards, judged by its volume, and the normals follow the triangles.
/// REQUIRES: normals; edges with at most two triangles.
Orientation orient(Mesh& mesh, bool byNormals);

} // namespace mesh
