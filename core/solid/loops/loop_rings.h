// The surface around a loop as a patch is to go on from it: the loop itself, and rings behind it (solid/README 1.3).
// Inside this room only.
//
// Beside a loop surfels are on one side only, and the surface leans: where it bends across the loop by k it lies too
// high by k o^2 / 2, with o how far aside the centre of the surfels is. Rings are put back by as much.
#pragma once

#include "core/solid/loops/loop.h"
#include "core/surface/surface.h"

namespace solid {

struct LoopRings {
    static constexpr std::size_t count = 2; ///< behind the loop

    std::vector<base::Vec3d> edge;   ///< of each of the loop's points
    std::vector<base::Vec3d> behind; ///< the nearer ring's places first, as many as the loop has in each
};

/// Model coordinates, float64. The same bits at any thread count.
LoopRings ringsAround(const surface::Surface& surface, const Loop& loop);

} // namespace solid
