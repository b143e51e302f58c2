#include "ui/render/camera.h"

#include <numbers>

namespace render {

using base::Vec3d;

/// Part of the image that a framed box fills, so that splats at its border are not cut.
constexpr double framedPart = 0.92;

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
    const double perX = focalPx() / (0.5 * framedPart * width), perY = focalPx() / (0.5 * framedPart * height);
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const base::Vec3f c{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                            corner & 4 ? box.hi.z : box.lo.z};
        const Vec3d v = base::cast<double>(c) - centre;
        distance = std::max(distance, std::max(std::abs(dot(v, r)) * perX, std::abs(dot(v, u)) * perY) - dot(v, f));
    }
    Camera out = *this;
    if (distance <= 0) // a single point: any distance shows it
        distance = length(target - eye);
    out.target = centre;
    out.eye = centre - f * distance;
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
