// A camera: where the eye is, what it looks at, how wide it sees, and what is cut away before it. Model coordinates
// relative to the origin, float64.
//
// Two projections. In perspective rays part from the eye and `fovDeg` tells how wide; where `orthoHeight` is set they
// are parallel, start in the plane through the eye across `forward`, and it tells how wide. Either way the camera sees
// what lies before that plane.
#pragma once

#include "core/base/ray.h"
#include "core/base/up_axis.h"
#include "core/render/clip_planes.h"

namespace render {

struct Camera {
    base::Vec3d eye{0, 0, 3};
    base::Vec3d target{0, 0, 0};
    base::Vec3d up{0, 1, 0};
    double fovDeg = 35;             ///< vertical angle of view, in perspective
    double orthoHeight = 0;         ///< model units from the image's lower edge to its upper; 0: perspective
    int width = 1280, height = 720; ///< pixels
    ClipPlanes clips;

    bool operator==(const Camera&) const = default;

    bool parallel() const { return orthoHeight > 0; }
    base::Vec3d forward() const;
    base::Vec3d right() const;
    base::Vec3d upright() const; ///< perpendicular to forward and right
    /// Pixels per model unit: at distance 1 along `forward`, or everywhere where rays are parallel.
    double focalPx() const;
    /// Pixels per model unit at a depth > 0 along `forward`.
    double pixelsPerUnit(double depth) const { return parallel() ? focalPx() : focalPx() / depth; }
    /// Ray through a place of the image; (0, 0) is the upper left corner, (0.5, 0.5) the centre of its first pixel.
    base::Rayd ray(double px, double py) const;
    /// What the clip planes leave of a ray of this camera.
    base::RayPart uncut(const base::Rayd& ray) const { return keptPart(ray, clips.all()); }
    /// Image place (x, y) in pixels and depth (z) along `forward`.
    base::Vec3d project(const base::Vec3d& p) const;

    /// The same view direction, moved (and in parallel projection widened) so that the box fills the image.
    Camera framing(const base::Box3f& box) const;
    /// The same picture of the box with parallel rays: the eye moved back or on, so that all of the box lies before it.
    Camera before(const base::Box3f& box) const;
    /// A three-quarter view of the box, of a model that stands with `up` upwards.
    static Camera looking(const base::Box3f& box, int width, int height, base::UpAxis up = base::UpAxis::Y);
};

} // namespace render
