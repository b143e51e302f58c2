// What is done to a finished mesh: rims where the definition ends are closed, small pieces are left out (RULES-4 B9,
// B10).
#pragma once

#include "core/mesh/marching/edge_walk.h"
#include "core/mesh/orient_mesh.h"

#include <functional>

namespace mesh {

struct FoldClosing {
    double cell = 0;           ///< side of the cubes that the mesh was made with
    bool everyLoop = false;    ///< those too across which there is no surface
    std::size_t longest = 24;  ///< edges of a loop that is closed
    std::size_t shortHole = 8; ///< edges of one across which the surface goes on
};

/// Closes boundary loops at which a vertex is of VertexKind::Fold by a fan around their middle: short ones where the
/// middle lies on the sheet around them, for there the surface is and only f has a step; all up to `longest` on
/// request, where the middle need not lie on the surface. The loops' vertices become Inner. Returns the
/// vertices in the middle. REQUIRES: normals and kinds; a manifold mesh.
std::vector<std::uint32_t> closeFolds(Mesh& mesh, const surface::Surface& surface, const FoldClosing& options);

/// Leaves out triangles that are not to be kept, by number; returns how many. Vertices stay.
std::size_t keepTriangles(Mesh& mesh, const std::function<bool(std::size_t)>& keep);

/// Leaves out vertices that no triangle uses.
void dropUnused(Mesh& mesh);

/// Leaves out pieces of fewer than `least` triangles and the vertices that only they used.
void dropSmallPieces(Mesh& mesh, const Orientation& pieces, std::size_t least);

} // namespace mesh
