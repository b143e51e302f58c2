// Models of the adaptive tests, and casts of them with their results copied.
#pragma once

#include "raycast_views.h"
#include "surface/shapes.h"

namespace views {

using raycast::AdaptiveCast, raycast::CastCounts, raycast::ImageRays, raycast::Known, raycast::Sample;
using surface::Surface;

constexpr double sphereRadius = 1;

inline const Surface& sphere() {
    static const Surface model =
        shapes::surfaceOf(shapes::sphere(8000, sphereRadius, 3.5 * shapes::sphereSpacing(8000, sphereRadius)));
    return model;
}

inline const Surface& torus() {
    static const Surface model = shapes::surfaceOf(shapes::torus(0.7, 0.3, 0.025, 3.5 * 0.025));
    return model;
}

struct Cast {
    std::vector<Sample> samples;
    std::vector<Known> known;
    CastCounts counts;
};

inline Cast once(AdaptiveCast& caster, const ImageRays& view, double quality) {
    Cast out;
    const raycast::AdaptiveImage image = caster.cast(view, {quality}, out.counts);
    out.samples.assign(image.samples.begin(), image.samples.end());
    out.known.assign(image.known.begin(), image.known.end());
    return out;
}

inline Cast fresh(const Surface& model, const ImageRays& view, double quality) {
    AdaptiveCast caster(model);
    return once(caster, view, quality);
}

inline std::vector<Sample> full(const Surface& model, const ImageRays& view) {
    CastCounts counts;
    return fullCast(model, view, counts);
}

inline bool same(std::span<const Sample> a, std::span<const Sample> b) {
    return std::ranges::equal(a, b, sameBits);
}

} // namespace views
