// The surfels along the boundaries of an open surface (selection/README 4): all loops, those up to a length, or the one
// nearest to a place.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <optional>

namespace selection {

struct RimQuestion {
    std::optional<base::Vec3d> at; ///< the loop nearest to this place alone
    double longest = std::numeric_limits<double>::infinity();
    double width = 0; ///< how far from the boundary surfels count; 0: as far as their own links reach
};

/// Empty where the surface has no boundary. Throws base::Cancelled.
tree::Selection alongRims(const surface::Surface& surface, const RimQuestion& question,
                          const base::Progress& progress = {});

} // namespace selection
