// What kind of surface a mesh is (mesh/README 6.1): manifold or not, its boundary, pieces, sides and genus. Uses vertex
// numbers only; positions play no role.
//
// An edge is manifold if one or two triangles share it, a vertex if its triangles form one umbrella, closed or open.
// Boundary loops stay within umbrellas, as if the mesh were cut apart where it is pinched. Triangles connected by
// shared vertices form a piece.
#pragma once

#include "core/mesh/mesh.h"

#include <optional>
#include <span>

namespace mesh {

struct Topology {
    std::size_t vertices = 0; ///< used by a triangle
    std::size_t unused = 0;   ///< other vertices
    std::size_t edges = 0;
    std::size_t faces = 0;    ///< triangles that name three vertices
    std::size_t improper = 0; ///< triangles that name one twice
    std::size_t components = 0;
    std::size_t boundaryEdges = 0, boundaryLoops = 0;
    std::size_t foldLoops = 0; ///< loops at which a vertex is of VertexKind::Fold
    std::size_t nonManifoldEdges = 0, nonManifoldVertices = 0;
    std::size_t opposedEdges = 0; ///< whose two triangles run along them in the same direction
    bool orientable = true;       ///< could turning triangles over leave no opposed edge?

    bool manifold() const { return nonManifoldEdges == 0 && nonManifoldVertices == 0; }
    long long euler() const {
        return static_cast<long long>(vertices) - static_cast<long long>(edges) + static_cast<long long>(faces);
    }
    /// Handles of all pieces, or crosscaps of one-sided ones: chi = 2 c - b - 2 g, or 2 c - b - k. Undefined for meshes
    /// that are not manifold or have pieces of both kinds.
    std::optional<long long> genus() const;
    bool mixed = false; ///< both one-sided and two-sided pieces
};

/// `kinds` may be empty. Throws std::out_of_range where a triangle names a vertex that is not there.
Topology topologyOf(std::span<const Triangle> triangles, std::size_t vertices, std::span<const VertexKind> kinds = {});

} // namespace mesh
