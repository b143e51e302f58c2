// What hangs together along the surface: all that links lead to from some surfels, up to creases and up to a curvature
// (selection/README 4).
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <numbers>

namespace selection {

struct FloodLimits {
    /// Links between normals that differ by more are not followed; pi: all are. Normals without sides are lines.
    double angleRad = std::numbers::pi;
    /// Surfels where the larger principal curvature exceeds this are not entered, nor where it is not known.
    double curvature = std::numeric_limits<double>::infinity();
    bool hidden = false; ///< goes on through what is hidden
};

/// `seeds` and all that is linked with them. Cost: what is reached. The same at any thread count.
tree::Selection flooded(const surface::Surface& surface, const tree::Selection& seeds, const FloodLimits& limits = {},
                        const base::Progress& progress = {});

/// The surfel nearest to a place, alone, of those that are not hidden where there is one. REQUIRES: a tree that is not
/// empty.
tree::Selection nearestTo(const tree::SurfelTree& tree, const base::Vec3d& x);

} // namespace selection
