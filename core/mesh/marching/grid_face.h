// A face of the grid and how its crossings pair up (mesh/README 3.3). Internal to the room.
//
// Only data of the face decide, so both cubes beside it get the same answer. Crossings are stored in order around the
// face; pairs never cross each other. A crossing without a partner is loose: the surface ends inside the face
// (boundary_trace.h).
#pragma once

#include "core/mesh/marching/surface_grid.h"

namespace mesh {

struct GridFace {
    static constexpr int mostCrossings = 8; ///< one on each half of its edges (graded_grid.h); else four

    GridIndex place; ///< its lowest node
    int axis = 0;    ///< across it
    int size = 1;    ///< its side, in cells
    int count = 0;
    std::array<std::uint32_t, mostCrossings> crossing{};
    std::array<int, mostCrossings> side{}; ///< of the face's edges, the one that it lies on

    /// The nodes and axes of the four edges: from the lowest node along u, then v, then back. u and v follow `axis`.
    static SurfaceGrid::EdgeName edge(const GridIndex& place, int axis, int side);
};

/// The face above a node across an axis; nothing where it lacks a corner. `around`: of the brick of the node or of a
/// neighbour below it.
bool faceAt(const SurfaceGrid& grid, const Neighbourhood& around, const GridIndex& place, int axis, GridFace& out);

struct FacePairs {
    std::array<int, GridFace::mostCrossings> partner{-1, -1, -1, -1, -1, -1, -1, -1}; ///< index of a crossing, or -1
};
FacePairs pairsOf(const CrossingGrid& grid, const GridFace& face);

} // namespace mesh
