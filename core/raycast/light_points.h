// Where light is evaluated (raycast/README 4.1): points of the surface, and of the ground below it, that the pixels
// of a picture show.
#pragma once

#include "core/raycast/environment.h"
#include "core/raycast/full_cast.h"

#include <functional>
#include <optional>

namespace raycast {

enum class Seen : std::uint8_t { Nothing, Model, Ground };

struct LightPoint {
    base::Vec3f x;
    base::Vec3f n;  ///< unit, facing against the ray
    float fade = 1; ///< of the ground, which has no edge
    float unit = 0; ///< h
    Seen seen = Seen::Nothing;
    bool back = false; ///< the side that outward normals do not point to
};

/// Samples with their rays. `width` is that of the image whose pixels they are, row by row; 0 where they are not
/// neighbours.
struct SeenSamples {
    std::span<const Sample> samples;
    std::function<base::Rayd(std::size_t)> ray;
    int width = 0;
};

/// All pixels of an image. REQUIRES: `rays` outlive it.
inline SeenSamples seenThrough(const ImageRays& rays, std::span<const Sample> samples) {
    const auto ray = [&rays](std::size_t i) {
        return rays.ray(static_cast<int>(i) % rays.width, static_cast<int>(i) / rays.width);
    };
    return {samples, ray, rays.width};
}

/// All that light can meet: the model, the ground, planes that cut.
struct LightScene {
    /// REQUIRES: `clips` outlive it.
    LightScene(const cells::AnySurface& surface, const Lighting& lighting, const Viewer& viewer,
               std::span<const base::Plane> clips = {});

    cells::AnySurface surface;
    Lighting lighting;
    Environment environment;
    std::span<const base::Plane> clips;
    float size = 1; ///< diagonal of the model's bounds
    bool oriented = false;
    std::optional<base::Plane> ground; ///< kept is what is above
    base::Vec3f middle;                ///< of the model, on the ground
};

/// The points of samples begin, begin + 1, ... Interpolated samples may lie off the surface by a fifth of a spacing;
/// all are moved onto it along the gradient, so that rays from them start where the surface is. In parallel.
void findLightPoints(const LightScene& scene, const SeenSamples& seen, std::size_t begin, std::span<LightPoint> out);

/// Where a ray starts that leaves a point to the side that n points to: off the surface by twice `secondaryEpsilon`
/// spacings, so that f has the sign of that side there.
base::Vec3f secondaryOrigin(const LightPoint& point, const base::Vec3f& n);

} // namespace raycast
