// A patch that takes after what surrounds it in relief (solid/README 1.5): heights of the surroundings over a smooth
// base go on in the hole.
#pragma once

#include "core/solid/loops/patch.h"
#include "core/surface/surface.h"

namespace solid {

enum class ReliefFate : std::uint8_t {
    Followed,
    Smooth,   ///< there is no relief around: nothing moved
    TooLittle ///< around it to follow: nothing moved
};

/// Moves the vertices of a patch that `shapePatch` made smooth, and turns their normals, unit ones. `fine` is `patch`
/// with its edges halved, or the same. Deterministic. Throws base::Cancelled by the scope.
ReliefFate followRelief(const surface::Surface& surface, const Loop& loop, const Patch& patch, Patch& fine,
                        std::vector<base::Vec3d>& normals);

} // namespace solid
