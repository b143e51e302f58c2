// Holes filled: boundary loops closed by patches of new surfels, as dense as those around (solid/README 1).
//
//     findBoundaryCurves      surface/curves/boundary_curves.h
//     evenLoop, touching      a loop as places one spacing apart; loops that cannot be filled    loop.h
//     patchOver               triangles over it                                                  patch.h
//     shapePatch              where they lie                                                     shape_patch.h
//     meetsModel, meet        what may not stay there                                            obstacles.h
//     followRelief            as rough as what surrounds them                                    relief.h
//     fillHoles               surfels at their corners
//     PlaneCap, capped        flat ones of what a plane cut off, with sharp edges                plane_cap.h
//
// Surfels that are there keep every bit. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/solid/loops/shape_patch.h"

#include <optional>

namespace solid {

struct FillOptions {
    Shape shape = Shape::Smooth;
    bool relief = false;                                      ///< a smooth patch takes after what surrounds it
    double longest = std::numeric_limits<double>::infinity(); ///< loops longer than this stay
    bool creases = true;                                      ///< caps of plane loops have sharp edges
    bool keepLargest = false;                                 ///< the longest loop stays: where an open scan ends
    std::optional<std::size_t> only;                          ///< one loop, by number
};

/// What became of a loop.
struct LoopFate {
    std::size_t number = 0; ///< longest first, as `pointclay boundary` counts them
    base::Vec3d middle;
    double length = 0;
    std::size_t surfels = 0; ///< that fill it
    bool asked = false;      ///< should be filled
    bool filled = false;     ///< is; without surfels of its own where it lies in another one
    bool flattened = false;  ///< no smooth patch stayed near and clear of the rest: it is flat
    bool plain = false;      ///< too little around it to follow in relief: it is smooth
    const char* why = "";    ///< what was asked for was not done because
};

struct Filled {
    surface::Surface surface;
    std::vector<LoopFate> loops;
};

/// Where the definition leaves the boundary limit to the model there is none once all loops are filled; models that
/// knew their rims know those that are left, of others the limit is made anew. Throws base::Error for curves, for
/// surfaces that have no boundary limit, and for a number that no loop has; base::Cancelled.
Filled fillHoles(const surface::Surface& surface, const FillOptions& options, const base::Progress& progress = {});

} // namespace solid
