// Caps of loops that lie in a plane and meet what is around at an angle (solid/README 1.7): in the plane, and with a
// sharp edge, as cuts have them (solid/README 2.4).
//
//     edgeOf         loop.h      the loop, where the area of the surfels ends
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
    std::vector<base::Point2> rim;
    bool convex = true; ///< as seen from outside: else it is the floor of a pit
    Loop loop;
    Patch patch; ///< its places and their spacings; no triangles

    /// Nothing where the model's normals have no sides, where the loop leaves every plane by more than 3 spacings (or
    /// .6 in the mean), surfels stand out of it by more than 1.5, or the cap would go on from what is around, or
    /// beyond it, as much as turn away from it; nor where it would have no places, or too many. `loop`: as edgeOf has
    /// it. Throws base::Cancelled.
    static std::optional<PlaneCap> over(const surface::Surface& surface, const Loop& loop);
};

/// With caps on, whose boundary limit is not yet looked for. Surfels that are there keep every bit but their labels.
/// Throws base::Cancelled.
surface::Surface capped(const surface::Surface& surface, std::span<const PlaneCap* const> caps, bool creases,
                        const base::Progress& progress = {});

} // namespace solid
