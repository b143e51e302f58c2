// The camera as a hand moves it: a turntable about the model's upright axis (y). Plain value; no widget.
//
//     eye = target + R(yaw, pitch) (0, 0, distance),   up = R(yaw, pitch) (0, 1, 0),   R = Ry(yaw) Rx(-pitch)
//
// so that looking straight down or up is no special case.
#pragma once

#include "ui/render/camera.h"

#include <span>

namespace ui {

struct OrbitView {
    base::Vec3d target;
    double distance = 3; ///< from the eye to the target, > 0
    double yawRad = 0;   ///< 0 looks along -z; grows as the eye moves towards +x
    double pitchRad = 0; ///< grows as the eye rises; -pi/2 to pi/2
    double fovDeg = 35;

    bool operator==(const OrbitView&) const = default;

    render::Camera camera(int width, int height) const;
    /// The view whose camera looks as `camera` does, upright as far as it goes.
    static OrbitView of(const render::Camera& camera);
    /// From the front, a little from the right and above.
    static OrbitView threeQuarter(std::span<const base::Box3f> boxes, int width, int height);

    /// The same target and distance, seen from a direction.
    void turnTo(const base::Vec3d& toEye, const base::Vec3d& up);
    /// Pointer moved by (dx, dy) pixels: half a turn for the image's height.
    void orbit(double dx, double dy, int height);
    /// The model follows the pointer in the plane through the target.
    void pan(double dx, double dy, int height);
    /// Nearer for positive steps, `pivot` keeps its place in the image.
    void zoom(double steps, const base::Vec3d& pivot);
    /// All of the boxes in the image, their centre in the middle; the direction stays.
    void frame(std::span<const base::Box3f> boxes, int width, int height);
};

} // namespace ui
