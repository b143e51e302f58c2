// A camera: where the eye is, what it looks at, how wide it sees. Model coordinates relative to the origin, float64.
#pragma once

#include "core/base/ray.h"

namespace render {

struct Camera {
    base::Vec3d eye{0, 0, 3};
    base::Vec3d target{0, 0, 0};
    base::Vec3d up{0, 1, 0};
    double fovDeg = 35;             ///< vertical angle of view
    int width = 1280, height = 720; ///< pixels

    bool operator==(const Camera&) const = default;

    base::Vec3d forward() const;
    base::Vec3d right() const;
    base::Vec3d upright() const; ///< perpendicular to forward and right
    /// Pixels per model unit at distance 1 along `forward`.
    double focalPx() const;
    /// Ray through a place of the image; (0, 0) is the upper left corner, (0.5, 0.5) the centre of its first pixel.
    base::Rayd ray(double px, double py) const;
    /// Image place (x, y) in pixels and depth (z) along `forward`.
    base::Vec3d project(const base::Vec3d& p) const;

    /// The same view direction, moved so that the box fills the image.
    Camera framing(const base::Box3f& box) const;
    /// A three-quarter view of the box.
    static Camera looking(const base::Box3f& box, int width, int height);
};

} // namespace render
