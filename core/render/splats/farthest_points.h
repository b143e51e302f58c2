// Farthest-point sampling among the surfels of a block: each point chosen is the one farthest from those before it, in
// position and normal. Vectorised, chosen at run time for the processor.
#pragma once

#include "core/surfel/surfel_block.h"

namespace render {

/// The surfels as arrays, and for each the chosen point that it is nearest to. Slots past the end are never chosen.
struct PointLanes {
    static constexpr int most = surfel::blockCapacity;
    alignas(64) float x[most], y[most], z[most], nx[most], ny[most], nz[most], support[most];
    alignas(64) float apart[most]; ///< squared distance from the nearest of those chosen; -1 of those themselves
    alignas(64) float owner[most]; ///< its number among them
    int size = 0;

    explicit PointLanes(const surfel::SurfelBlock& block);
    /// Chooses up to `count`, fewer where places coincide; their slots go to `out`. Normals that differ by a small
    /// angle lie `angle * turn` apart.
    int choose(int count, float turn, bool oriented, int* out);
};

} // namespace render
