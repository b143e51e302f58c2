// Full-image ray casting: the exact first hit of every pixel's ray on the surface (raycast/README 1.2). Models with
// cells show their sharp edges.
//
// All faster ways of drawing are compared with this picture. Rays of neighbouring pixels are intersected together, in
// tiles, because they meet the same surfels; the result does not depend on that.
#pragma once

#include "core/base/plane.h"
#include "core/base/progress.h"
#include "core/cells/any_surface.h"
#include "core/surface/rays/intersect.h"
#include "core/surfel/surfel.h"

namespace raycast {

/// The rays of an image. The one through the centre of pixel (column, row) runs from
/// eye + originAcross * column + originDown * row along corner + across * column + down * row: rays of a perspective
/// camera share their origin, parallel ones their direction. They see what all planes keep.
struct ImageRays {
    base::Vec3d eye, originAcross, originDown;
    base::Vec3d corner, across, down;
    int width = 0, height = 0;
    std::span<const base::Plane> clips;

    base::Rayd ray(int column, int row) const {
        return {eye + originAcross * column + originDown * row, normalized(corner + across * column + down * row)};
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
std::vector<Sample> fullCast(const cells::AnySurface& surface, const ImageRays& rays, CastCounts& counts,
                             const base::Progress& progress = {});

/// Colour and mask at a point of the surface: means of the surfels', with the weights of the surface itself.
void blendAttributes(const surface::Surface& surface, const base::Vec3f& x, Sample& out);

} // namespace raycast
