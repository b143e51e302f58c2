// Loose ends and loops of cubes of several sizes (mesh/README 3.16): what boundary_trace.h and cube_loops.h tell of
// cubes of one size. Internal to the room.
#pragma once

#include "core/mesh/marching/cube_loops.h"
#include "core/mesh/marching/graded_grid.h"

namespace mesh {

/// All loose ends of the grid, in the order of faces.
std::vector<LooseEnd> looseEnds(const GradedGrid& grid);

/// Has a face of the cube an end of a section that nothing goes on from: is a rim in it?
bool hasLooseEnd(const GradedGrid& grid, const CubeLevels::Cube& cube);

/// Replaces `out` by the loops of a cube.
void loopsOf(const GradedGrid& grid, const LooseEnds& loose, const CubeLevels::Cube& cube, std::vector<Loop>& out);

} // namespace mesh
