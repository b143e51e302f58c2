// Full-image ray casting: the exact first meeting of every pixel's ray with the surface (alg. 4.2).
//
// The picture that all faster ways of drawing are compared with. Rays of neighbouring pixels go to the intersection
// together, in tiles, because they meet the same surfels; the result does not depend on that.
#pragma once

#include "core/base/progress.h"
#include "core/surface/intersect.h"
#include "core/surfel/surfel.h"

namespace raycast {

/// The rays of an image: through the centre of pixel (column, row) runs corner + column * across + row * down.
struct ImageRays {
    base::Vec3d eye;
    base::Vec3d corner, across, down;
    int width = 0, height = 0;

    base::Rayf ray(int column, int row) const {
        return {base::cast<float>(eye), base::cast<float>(normalized(corner + across * column + down * row))};
    }
};

/// What a pixel shows.
struct Sample {
    surface::RayHit<float> hit;
    surfel::Colour colour = surfel::white; ///< blended like the surface itself, where the model has colours
    float mask = 0;
};

struct CastCounts {
    std::size_t rays = 0, pixels = 0, hits = 0, evaluations = 0;
    double seconds = 0;
};

/// Samples row by row from the top. In parallel; the same bits at any thread count. Throws base::Cancelled.
std::vector<Sample> fullCast(const surface::Surface& surface, const ImageRays& rays, CastCounts& counts,
                             const base::Progress& progress = {});

/// Colour and mask at a place of the surface: means of the surfels', weighted like their positions (alg. 2.1).
void blendAttributes(const surface::Surface& surface, const base::Vec3f& x, Sample& out);

} // namespace raycast
