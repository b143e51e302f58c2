// Changes of the shape of a whole model or of what is selected of it (selection/README 9): smoother, sharper, thicker,
// rougher. Each surfel gets them in the measure of the selection, under its limit, and of 1 - mask.
#pragma once

#include "core/base/progress.h"
#include "core/selection/parts.h"

namespace selection {

/// Surfels go towards the surface of supports `scale` times as wide, `amount` of the way: 1 onto it, below 0 away from
/// it, which sharpens. Normals likewise. Surfels without a foot there stay. REQUIRES: scale >= 1.
surface::Surface smoothed(const surface::Surface& surface, double scale, double amount, Limit limit,
                          const base::Progress& progress = {});

/// How far a place is raised along the normal, and how that varies.
struct Height {
    double value = 0;
    base::Vec3d slope;
};
/// p' = p + w height(p) n, normals and supports by the exact Jacobian. Model units. Throws base::Error where normals
/// have no sides, or surfels would come too far from the model's origin to keep their places.
surface::Surface raised(const surface::Surface& surface, const std::function<Height(const base::Vec3d&)>& height,
                        Limit limit, const base::Progress& progress = {});

/// Band-limited noise within -1 and 1, features as wide as `size`, with its exact slope (Perlin 2002). A function of
/// place and seed alone.
Height noiseAt(const base::Vec3d& x, double size, std::uint64_t seed);

} // namespace selection
