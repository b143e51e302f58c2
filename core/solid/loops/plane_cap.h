// Caps of loops that lie in a plane and meet what is around at an angle (solid/README 1.7): in the plane, and with a
// sharp edge, as cuts have them (solid/README 2.4).
//
//     edgeOf         loop.h      the loop, where the area of the surfels ends
//     nestedLoops                loops that lie in others, as the bore's in the mouth of a pipe
//     PlaneCap::over             is there a plane, and do all sides turn there?
//     capped                     the model with its caps, both sides of each edge cells
#pragma once

#include "core/base/outline.h"
#include "core/base/progress.h"
#include "core/solid/loops/patch.h"
#include "core/solid/primitive.h"
#include "core/surface/surface.h"

#include <optional>

namespace solid {

struct PlaneCap {
    Pose pose; ///< its plane; the z axis is the way that it faces
    std::vector<std::vector<base::Point2>> rims;
    bool convex = true;            ///< as seen from outside: else it is the floor of a pit
    Loop loop;                     ///< the places of all its loops
    std::vector<std::size_t> ends; ///< of each of them, in `loop`
    Patch patch;                   ///< its places and their spacings; no triangles

    /// Nothing where the model's normals have no sides, where the first loop leaves every plane by more than 3 spacings
    /// (or .6 in the mean), surfels stand out of it by more than 1.5, or the cap would go on from what is around, or
    /// beyond it, as much as turn away from it; nor where it would have no places, or too many. `loops`: as edgeOf has
    /// them; all but the first lie in that. Throws base::Cancelled.
    static std::optional<PlaneCap> over(const surface::Surface& surface, std::span<const Loop> loops);
};

/// Of each loop the one that it lies in, in its plane, and where a cap over that one ends: the smallest of them.
/// `loops`: as edgeOf has them; those without places lie in none and around none.
std::vector<std::optional<std::size_t>> nestedLoops(std::span<const Loop> loops);

/// With caps on, whose boundary limit is not yet looked for. Surfels that are there keep every bit but their labels.
/// Throws base::Cancelled.
surface::Surface capped(const surface::Surface& surface, std::span<const PlaneCap* const> caps, bool creases,
                        const base::Progress& progress = {});

} // namespace solid
