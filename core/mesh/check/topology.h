// What kind of surface a mesh is: manifold or not, its boundary, its pieces, whether it has two sides, its genus. From
// the triangles' numbers alone; positions have no say.
//
// An edge is manifold where one or two triangles share it, a vertex where its triangles form one fan, closed or open.
// Boundary loops are followed from fan to fan, as cutting the mesh apart where it is pinched would leave them. Pieces
// are what shares vertices.
#pragma once

#include "core/mesh/mesh.h"

#include <optional>
#include <span>

namespace mesh {

struct Topology {
    std::size_t vertices = 0; ///< that a triangle uses
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
    /// Sum over the pieces, of handles, or of crosscaps where it has one side: chi = 2 c - b - 2 g, or - k. Nothing for
    /// what is not manifold, nor for pieces of both kinds together.
    std::optional<long long> genus() const;
    bool mixed = false; ///< some pieces have two sides and some have one
};

/// `kinds` may be empty. Throws std::out_of_range where a triangle names a vertex that is not there.
Topology topologyOf(std::span<const Triangle> triangles, std::size_t vertices, std::span<const VertexKind> kinds = {});

} // namespace mesh
