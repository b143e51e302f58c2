// Triangulates a loop around a cube (mesh/README 3.6). Internal to the room.
//
// Dynamic programming over all triangulations finds short edges and triangles that agree with the normals at their
// corners. No diagonal may join two vertices on the same face of the cube: the cube behind that face might draw the
// same edge, which would then have more than two triangles. If no triangulation remains, a fan about a new vertex in
// the middle fills the loop.
#pragma once

#include "core/mesh/marching/cube_loops.h"

namespace mesh {

/// Positions and normals of a loop's vertices, in its order.
struct LoopShape {
    std::span<const LoopVertex> loop;
    std::span<const base::Vec3d> positions;
    std::span<const base::Vec3f> normals; ///< unit
};

/// Triangles as indices into the loop, in its direction; loop.size() stands for the middle. Returns whether it needs
/// one. Fewer than 3 vertices have none.
bool fillLoop(const LoopShape& shape, std::vector<std::array<int, 3>>& out);

} // namespace mesh
