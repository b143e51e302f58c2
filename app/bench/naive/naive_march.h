// The naive marching cubes: a grid of one cell size over the model's box, the value at the nodes near surfels, linear
// crossings along edges, a loop around each cube. Signs at corners, so that near sheets and rims are not its own. One
// thread.
#pragma once

#include "app/bench/naive/naive_surface.h"

#include <array>

namespace bench {

struct NaiveMesh {
    std::vector<base::Vec3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// REQUIRES: a surface that NaiveSurface speaks, cell > 0. Memory follows the volume of the box in cells.
NaiveMesh naiveMarch(const NaiveSurface& surface, double cell);

} // namespace bench
