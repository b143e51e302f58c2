#include "ui/orbit_view.h"

#include <algorithm>
#include <numbers>

namespace ui {

using base::Vec3d;
static constexpr double pi = std::numbers::pi;

static Vec3d turned(const OrbitView& view, const Vec3d& v) {
    const double cp = std::cos(view.pitchRad), sp = std::sin(view.pitchRad);
    const Vec3d pitched{v.x, cp * v.y + sp * v.z, cp * v.z - sp * v.y};
    const double cy = std::cos(view.yawRad), sy = std::sin(view.yawRad);
    return {cy * pitched.x + sy * pitched.z, pitched.y, cy * pitched.z - sy * pitched.x};
}

render::Camera OrbitView::camera(int width, int height) const {
    render::Camera out;
    out.target = target;
    out.eye = target + turned(*this, {0, 0, distance});
    out.up = turned(*this, {0, 1, 0});
    out.fovDeg = fovDeg;
    out.width = width;
    out.height = height;
    return out;
}

OrbitView OrbitView::of(const render::Camera& camera) {
    const Vec3d back = camera.eye - camera.target;
    OrbitView out;
    out.target = camera.target;
    out.distance = base::length(back);
    out.fovDeg = camera.fovDeg;
    const double flat = std::hypot(back.x, back.z);
    out.pitchRad = std::atan2(back.y, flat);
    // Straight above or below, the yaw is in the up vector alone.
    const Vec3d heading = flat > 1e-9 * out.distance ? back : camera.up * (back.y > 0 ? -1.0 : 1.0);
    out.yawRad = std::atan2(heading.x, heading.z);
    return out;
}

void OrbitView::turnTo(const Vec3d& toEye, const Vec3d& up) {
    render::Camera there = camera(1, 1);
    there.eye = target + toEye * distance;
    there.up = up;
    const OrbitView turned = of(there);
    yawRad = turned.yawRad, pitchRad = turned.pitchRad;
}

void OrbitView::orbit(double dx, double dy, int height) {
    const double perPixel = pi / std::max(height, 1);
    yawRad = std::remainder(yawRad - dx * perPixel, 2 * pi);
    pitchRad = std::clamp(pitchRad + dy * perPixel, -pi / 2, pi / 2);
}

void OrbitView::pan(double dx, double dy, int height) {
    const double unitsPerPixel = 2 * distance * std::tan(fovDeg * pi / 360) / std::max(height, 1);
    target += turned(*this, {-dx * unitsPerPixel, dy * unitsPerPixel, 0});
}

void OrbitView::zoom(double steps, const Vec3d& pivot) {
    const double factor = std::pow(0.85, steps);
    target = pivot + (target - pivot) * factor;
    distance *= factor;
}

/// A corner at (x, y, z) right, above and behind the centre is inside where |x| <= k (distance + z), alike for y; k is
/// the slope of the image's margin. The target is the centre, so that the model turns about its middle.
void OrbitView::frame(std::span<const base::Box3f> boxes, int width, int height) {
    constexpr double part = 0.92; // of the image that the boxes may fill
    base::Box3f whole;
    for (const base::Box3f& box : boxes)
        whole.extend(box);
    if (whole.empty())
        return;
    target = base::cast<double>(whole.centre());
    const render::Camera now = camera(width, height);
    const double kx = 0.5 * part * width / now.focalPx(), ky = 0.5 * part * height / now.focalPx();
    const Vec3d r = now.right(), u = now.upright(), f = now.forward();
    double needed = 0;
    for (const base::Box3f& box : boxes)
        for (int corner = 0; corner < 8; ++corner) {
            const base::Vec3f c{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                                corner & 4 ? box.hi.z : box.lo.z};
            const Vec3d v = base::cast<double>(c) - target;
            needed = std::max({needed, std::abs(dot(v, r)) / kx - dot(v, f), std::abs(dot(v, u)) / ky - dot(v, f)});
        }
    if (needed > 0) // else a single point: any distance shows it
        distance = needed;
}

OrbitView OrbitView::threeQuarter(std::span<const base::Box3f> boxes, int width, int height) {
    OrbitView out;
    out.yawRad = 0.42;
    out.pitchRad = 0.27;
    out.frame(boxes, width, height);
    return out;
}

} // namespace ui
