#include "core/render/camera.h"

#include <algorithm>
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
    return parallel() ? height / orthoHeight : 0.5 * height / std::tan(fovDeg * (std::numbers::pi / 360));
}

base::Rayd Camera::ray(double px, double py) const {
    const Vec3d aside = right() * (px - 0.5 * width) - upright() * (py - 0.5 * height);
    if (parallel())
        return {eye + aside * (1 / focalPx()), forward()};
    return {eye, normalized(forward() * focalPx() + aside)};
}

Vec3d Camera::project(const Vec3d& p) const {
    const Vec3d v = p - eye;
    const double z = dot(v, forward()), f = focalPx() / (parallel() ? 1 : z);
    return {0.5 * width + f * dot(v, right()), 0.5 * height - f * dot(v, upright()), z};
}

/// Half the extent of a box along a unit direction.
static double halfAlong(const base::Box3f& box, const Vec3d& axis) {
    const Vec3d half = base::cast<double>(box.hi - box.lo) * 0.5;
    return std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
}

Camera Camera::before(const base::Box3f& box) const {
    Camera out = *this;
    if (box.empty() || !parallel())
        return out;
    // Twice the half extent, so that splats and supports at the box's border are not cut.
    const double middle = dot(base::cast<double>(box.centre()) - eye, forward());
    out.eye = eye + forward() * (middle - 2 * halfAlong(box, forward()) - orthoHeight);
    return out;
}

/// Parallel rays: the box's extents across them, in its middle.
static Camera framedParallel(const Camera& camera, const base::Box3f& box) {
    Camera out = camera;
    const double across = halfAlong(box, camera.right()) * camera.height / camera.width;
    const double needed = 2 * std::max(across, halfAlong(box, camera.upright())) / framedPart;
    if (needed > 0) // else a single point: any height shows it
        out.orthoHeight = needed;
    out.target = base::cast<double>(box.centre());
    out.eye = out.target - camera.forward() * length(camera.target - camera.eye);
    return out.before(box);
}

Camera Camera::framing(const base::Box3f& box) const {
    if (box.empty())
        return *this;
    if (parallel())
        return framedParallel(*this, box);
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

Camera Camera::looking(const base::Box3f& box, int width, int height, base::UpAxis up) {
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.target = {0, 0, 0};
    // 21 degrees above the horizon: clearly more than half the angle of view, at which the top of whatever fills the
    // picture's height would be seen edge-on.
    camera.eye = fromStanding(up, {0.45, 0.42, 1});
    camera.up = upRow(up).up;
    return camera.framing(box);
}

} // namespace render
