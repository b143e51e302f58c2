// A face of the grid and how its crossings are joined (RULES-4 B3). Internal to the room.
//
// Only what the face itself knows decides, so both cubes beside it get the same answer. Crossings are in the order of
// the way around the face; pairs do not cross each other. A crossing without a partner is loose: the surface ends
// inside the face (rim_trace.h).
#pragma once

#include "core/mesh/marching/surface_grid.h"

namespace mesh {

struct GridFace {
    static constexpr int mostCrossings = 4;

    Place place;  ///< its lowest node
    int axis = 0; ///< across it
    int count = 0;
    std::array<std::uint32_t, mostCrossings> crossing{};
    std::array<int, mostCrossings> side{}; ///< of the face's edges, the one that it lies on

    /// The nodes and axes of the four edges: from the lowest node along u, then v, then back. u and v follow `axis`.
    static SurfaceGrid::EdgeName edge(const Place& place, int axis, int side);
};

/// The face above a node across an axis; nothing where it lacks a corner. `around`: of the brick of the node or of a
/// neighbour below it.
bool faceAt(const SurfaceGrid& grid, const Neighbourhood& around, const Place& place, int axis, GridFace& out);

struct FacePairs {
    std::array<int, GridFace::mostCrossings> partner{-1, -1, -1, -1}; ///< index of a crossing of the face, or -1
};
FacePairs pairsOf(const SurfaceGrid& grid, const GridFace& face);

} // namespace mesh
