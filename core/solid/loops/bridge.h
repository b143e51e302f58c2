// Two boundary loops joined by a sheet that goes on from the surface at both (solid/README 1.6), sampled as densely as
// around them: what is open becomes a tube, a handle, a torus again.
//
//     findBoundaryCurves      surface/curves/boundary_curves.h
//     BridgeSheet             which place is led to which, and how    bridge_sheet.h
//     patchBetween            triangles over it                       patch.h
//     PatchSurfels            surfels at their corners                patch_surfels.h
//
// Surfels that are there keep every bit. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <array>
#include <optional>

namespace solid {

struct Bridged {
    surface::Surface surface;
    std::array<std::size_t, 2> loops; ///< by number, longest first, as `pointclay boundary` counts them
    std::size_t surfels = 0;          ///< that the sheet has
};

/// `loops`: two numbers; the two that there are unless told. The boundary limit is made anew where the definition
/// leaves it to the model. Throws base::Error where there are not two such loops, where one touches itself or the
/// other, where the sides of the surfaces do not agree, and where the sheet would fold or run into the model;
/// base::Cancelled.
Bridged bridge(const surface::Surface& surface, const std::optional<std::array<std::size_t, 2>>& loops,
               const base::Progress& progress = {});

} // namespace solid
