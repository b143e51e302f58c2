// How far one model's surfels stand from another model's surface (process/README 12.2): exact feet, in double, positive
// on the side to which that surface's normals point.
#pragma once

#include "core/surface/surface.h"

namespace process {

/// Signed distances of the surfels that have a foot, and how many have none.
struct DeviationFigures {
    std::size_t count = 0;  ///< surfels with a foot
    std::size_t beyond = 0; ///< those whose foot lies beyond the surface's boundary: it ends before them
    std::size_t lost = 0;   ///< those for which no nearby foot was found, as between sheets
    bool sided = true;      ///< the surface has sides; otherwise all distances are positive
    double rms = 0, mean = 0;
    double p99 = 0, max = 0; ///< of sizes
};

/// What the figures are made of, in tree order.
struct Deviations {
    DeviationFigures figures;
    std::vector<double> distance;        ///< NaN where there is no foot that counts
    std::vector<surface::Status> status; ///< Ok; BeyondBoundary; all else is lost
};

/// `shift`: what is added to a position of `from` to have it in the coordinates of `to`, that is the difference of
/// their origins. In parallel, the same bits at any thread count. Throws base::Cancelled.
Deviations deviationsOf(const tree::SurfelTree& from, const surface::Surface& to, const base::Vec3d& shift,
                        const base::Progress& progress = {});
inline DeviationFigures deviationOf(const tree::SurfelTree& from, const surface::Surface& to, const base::Vec3d& shift,
                                    const base::Progress& progress = {}) {
    return deviationsOf(from, to, shift, progress).figures;
}

} // namespace process
