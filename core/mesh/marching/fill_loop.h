// Triangles that fill a loop around a cube (RULES-4 B6). Internal to the room.
//
// By dynamic programming over all triangulations: short edges, and triangles that lie as the normals at their corners
// tell. No diagonal joins two vertices of one face of the cube: the cube behind that face may have the same edge, and
// it would get more than two triangles. Where no triangulation is left, a vertex in the middle is the fan's.
#pragma once

#include "core/mesh/marching/cube_loops.h"

namespace mesh {

/// Positions and normals of a loop's vertices, in its order.
struct LoopShape {
    std::span<const LoopVertex> loop;
    std::span<const base::Vec3d> positions;
    std::span<const base::Vec3f> normals; ///< unit
};

/// Calls of indices into the loop, which run around as the loop does; loop.size() stands for the middle. Returns
/// whether a middle was needed. REQUIRES: at least 3 vertices.
bool fillLoop(const LoopShape& shape, std::vector<std::array<int, 3>>& out);

} // namespace mesh
