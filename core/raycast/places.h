// Where light is asked about: places of the surface, and of the ground below it, that the pixels of a picture show.
#pragma once

#include "core/raycast/environment.h"
#include "core/raycast/full_cast.h"

#include <functional>
#include <optional>

namespace raycast {

enum class Seen : std::uint8_t { Nothing, Model, Ground };

struct Place {
    base::Vec3f x;
    base::Vec3f n;  ///< unit, facing against the ray
    float fade = 1; ///< of the ground, which ends nowhere
    float unit = 0; ///< h
    Seen seen = Seen::Nothing;
    bool back = false; ///< the side that outward normals do not point to
};

/// What light may be asked about: samples with their rays. `width` is that of the image whose pixels they are, row by
/// row; 0: they are no neighbours.
struct SeenSamples {
    std::span<const Sample> samples;
    std::function<base::Rayd(std::size_t)> ray;
    int width = 0;
};

/// Of an image, all its pixels. REQUIRES: `rays` outlive it.
inline SeenSamples seenThrough(const ImageRays& rays, std::span<const Sample> samples) {
    const auto ray = [&rays](std::size_t i) {
        return rays.ray(static_cast<int>(i) % rays.width, static_cast<int>(i) / rays.width);
    };
    return {samples, ray, rays.width};
}

/// All that light meets: the model, the ground, planes that cut.
struct LightScene {
    /// REQUIRES: `clips` outlive it.
    LightScene(const surface::Surface& surface, const Lighting& lighting, const Viewer& viewer,
               std::span<const base::Plane> clips = {});

    surface::Surface surface;
    Lighting lighting;
    Environment environment;
    std::span<const base::Plane> clips;
    float size = 1; ///< diagonal of the model's bounds
    bool oriented = false;
    std::optional<base::Plane> ground; ///< kept is what is above
    base::Vec3f middle;                ///< of the model, on the ground
};

/// Places of samples. Interpolated ones may lie off the surface by a fifth of a spacing: all are moved onto it along
/// the gradient, so that rays from them start where the surface is. In parallel.
void findPlaces(const LightScene& scene, const SeenSamples& seen, std::size_t begin, std::span<Place> out);

/// Where a ray begins that leaves a place to the side that n points to: off the surface by twice `secondaryEpsilon`
/// spacings, so that f there has that side's sign.
base::Vec3f startBeside(const Place& place, const base::Vec3f& n);

} // namespace raycast
