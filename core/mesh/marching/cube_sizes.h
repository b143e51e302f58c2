// How large cubes are where, from how far apart the surfels are (mesh/README 3.16) and how thin walls (3.17). Internal
// to the room.
#pragma once

#include "core/mesh/marching/cube_levels.h"

#include <optional>

namespace mesh {

/// Of cubes of several sizes: the side of the smallest, and how often that is doubled for the largest.
struct CubeSizes {
    double cell = 0;
    int highest = 0;
    std::vector<float> walls; ///< how thin, by surfel in the tree's order; empty where none are (thin_walls.h)
};

/// Nothing where cubes of one size, `cell`, do for all but a few surfels. `median`: their spacing.
std::optional<CubeSizes> cubeSizesOf(const surface::Surface& surface, double median, double cell,
                                     std::vector<float> walls);

/// Cubes that surfels want smaller than they are: such as are near one and larger than its spacing. By level, as
/// CubeLevels wants them.
std::vector<std::vector<BrickBits>> cubesToHalve(const surface::Surface& surface, const Lattice& lattice,
                                                 const CubeSizes& sizes);

} // namespace mesh
