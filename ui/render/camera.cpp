#include "ui/render/camera.h"

#include <limits>
#include <numbers>

namespace render {

using base::Vec3d;

/// Part of the image that a framed box fills, so that splats at its border are not cut.
constexpr double framedPart = 0.94;

Vec3d Camera::forward() const {
    return normalized(target - eye, {0, 0, -1});
}

Vec3d Camera::right() const {
    const Vec3d f = forward();
    const Vec3d side = cross(f, normalized(up, {0, 1, 0}));
    return length(side) > 1e-9 ? normalized(side) : base::perpendicular(f);
}

Vec3d Camera::upright() const {
    return cross(right(), forward());
}

double Camera::focalPx() const {
    return 0.5 * height / std::tan(fovDeg * (std::numbers::pi / 360));
}

base::Rayd Camera::ray(double px, double py) const {
    const Vec3d direction = forward() * focalPx() + right() * (px - 0.5 * width) - upright() * (py - 0.5 * height);
    return {eye, normalized(direction)};
}

Vec3d Camera::project(const Vec3d& p) const {
    const Vec3d v = p - eye;
    const double z = dot(v, forward()), f = focalPx();
    return {0.5 * width + f * dot(v, right()) / z, 0.5 * height - f * dot(v, upright()) / z, z};
}

Camera Camera::framing(const base::Box3f& box) const {
    if (box.empty())
        return *this;
    const Vec3d f = forward(), r = right(), u = upright(), centre = base::cast<double>(box.centre());
    // Along one image axis with slope k at its margin, a corner (x, z) is inside for an eye at (a, c) if
    // |x - a| <= k (z - c). With A = max(x - k z) and B = max(-x - k z) the farthest c forward is -(A + B) / 2k, at
    // a = (A - B) / 2, and that a serves any c behind it.
    const double kx = 0.5 * framedPart * width / focalPx(), ky = 0.5 * framedPart * height / focalPx();
    const double most = std::numeric_limits<double>::lowest();
    double ax = most, bx = most, ay = most, by = most;
    for (int corner = 0; corner < 8; ++corner) {
        const base::Vec3f c{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                            corner & 4 ? box.hi.z : box.lo.z};
        const Vec3d v = base::cast<double>(c) - centre;
        const double x = dot(v, r), y = dot(v, u), z = dot(v, f);
        ax = std::max(ax, x - kx * z), bx = std::max(bx, -x - kx * z);
        ay = std::max(ay, y - ky * z), by = std::max(by, -y - ky * z);
    }
    double distance = std::max((ax + bx) / (2 * kx), (ay + by) / (2 * ky));
    if (distance <= 0) // a single point: any distance shows it
        distance = length(target - eye);
    Camera out = *this;
    out.target = centre + r * (0.5 * (ax - bx)) + u * (0.5 * (ay - by));
    out.eye = out.target - f * distance;
    return out;
}

Camera Camera::looking(const base::Box3f& box, int width, int height) {
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.target = {0, 0, 0};
    camera.eye = {0.45, 0.3, 1};
    return camera.framing(box);
}

} // namespace render
