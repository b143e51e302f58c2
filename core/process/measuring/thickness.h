// How thick what a surface encloses is: from a place of the surface straight inwards to where the surface is met from
// within (process/README 12.4). Needs normals that have sides.
#pragma once

#include "core/process/measuring/geodesic.h"

namespace process {

struct ThicknessFigures {
    std::size_t count = 0; ///< surfels that have something opposite
    std::size_t none = 0;  ///< those that have not: the surface is open there
    double min = 0, p1 = 0, median = 0, mean = 0, max = 0;
};

/// Of every surfel, in tree order; NaN where there is nothing opposite.
struct Thicknesses {
    ThicknessFigures figures;
    std::vector<double> at;
};

/// In float32, in parallel, the same bits at any thread count. Throws base::Error where normals have no sides,
/// base::Cancelled.
Thicknesses thicknessesOf(const surface::Surface& surface, const base::Progress& progress = {});

/// At one place, in float64.
struct ThicknessAt {
    GeodesicPoint foot;   ///< of the place
    base::Vec3d opposite; ///< NaN where there is nothing
    double thickness = 0; ///< NaN likewise
    double leanRad = 0;   ///< angle of both sides: 0 where they are parallel
};
/// Throws base::Error as above, or where there is no surface.
ThicknessAt thicknessAt(const surface::Surface& surface, const base::Vec3d& x);

} // namespace process
