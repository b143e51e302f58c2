// How far one surface is from another that it stands for: measured at every sample of the model, with the product's own
// projection (reduce/README 6).
#pragma once

#include "core/reduce/places.h"

namespace reduce {

/// Lengths in model units.
struct Report {
    std::size_t count = 0;                 ///< surfels
    double rms = 0, p999 = 0, max = 0;     ///< the model's samples to the surface
    double normalsDeg = 0;                 ///< angle between the two surfaces' normals, rms
    int leastSupports = 0;                 ///< over a foot of the model
    std::size_t holes = 0;                 ///< samples that have a foot on the model's surface and none here
    double surfaceRms = 0, surfaceMax = 0; ///< between the two surfaces, at the model's feet
    double denseRms = 0;                   ///< the model's samples to its own surface
    bool ellipsoids = false;               ///< are supports ellipsoids?
    std::size_t strays = 0;                ///< samples without a foot on the model's own surface: not counted above
    std::size_t picked = 0; ///< surfels that are the model's own, thinned: of cells that nothing can be fitted to
};

/// Where a hole is, on the model's surface.
struct Missed {
    std::vector<base::Vec3f> position, normal;
    std::vector<int> samples; ///< with weight where the search for a foot ended
};

/// The places alone: what counts as the model's samples are then they.
Report verifyPlaces(const Places& places, const surface::Surface& surface, const base::Progress& progress = {});

/// In parallel. Throws base::Cancelled.
Report verify(const Dense& dense, const surface::Surface& surface, Missed& missed, const base::Progress& progress = {});
/// The same of a model that has not been looked at yet.
Report verifyAgainst(const surface::Surface& model, const surface::Surface& surface,
                     const base::Progress& progress = {});

} // namespace reduce
