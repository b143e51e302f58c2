#include "ui/orbit_view.h"

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

void OrbitView::frame(const base::Box3f& box, int width, int height) {
    const render::Camera framed = camera(width, height).framing(box);
    target = framed.target;
    distance = base::length(framed.eye - framed.target);
}

std::span<const NamedView> namedViews() {
    static const NamedView table[] = {
        {"Front", "1", 0, 0},       {"Back", "Ctrl+1", 180, 0}, {"Right", "3", 90, 0},
        {"Left", "Ctrl+3", -90, 0}, {"Top", "7", 0, 90},        {"Bottom", "Ctrl+7", 0, -90},
    };
    return table;
}

} // namespace ui
