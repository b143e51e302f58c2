#include "ui/view/placement.h"

#include <cmath>
#include <numbers>

namespace ui {

using base::Vec3d;
constexpr double halfTurn = std::numbers::pi;

static Vec3d axisOf(int axis) {
    Vec3d out;
    out[static_cast<std::size_t>(axis)] = 1;
    return out;
}

AxisAngle axisAngleOf(const Rotation& turn) {
    const Rotation r = turn.w < 0 ? Rotation{-turn.w, -turn.v} : turn;
    const double sine = length(r.v);
    if (!(sine > 1e-12))
        return {};
    return {r.v / sine, 2 * std::atan2(sine, r.w) * 180 / halfTurn};
}

Rotation rotationOf(const AxisAngle& turn) {
    const double size = length(turn.axis);
    return size > 0 ? Rotation::about(turn.axis / size, turn.degrees * halfTurn / 180) : Rotation();
}

// --- shapes ---

std::vector<HandleShape> handleShapes(const render::Camera& camera, const Vec3d& middle, double lengthPx) {
    constexpr int parts = 48;
    constexpr double ring = 1.25, inner = 0.2, diagonal = 0.95; // lengths of arrows
    const double depth = camera.project(middle).z;
    if (!(depth > 0))
        return {};
    const double reach = lengthPx / camera.pixelsPerUnit(depth);
    std::vector<HandleShape> out;
    out.push_back({{Handle::Kind::Free, 0}, {middle}});
    out.push_back({{Handle::Kind::Scale, 0}, {middle + (camera.right() + camera.upright()) * (diagonal * reach)}});
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3d a = axisOf(axis) * reach;
        out.push_back({{Handle::Kind::Move, axis}, {middle + a * inner, middle + a}});
    }
    for (int axis = 0; axis < 3; ++axis) {
        HandleShape circle{{Handle::Kind::Turn, axis}, {}};
        const Vec3d a = axisOf((axis + 1) % 3) * (ring * reach), b = axisOf((axis + 2) % 3) * (ring * reach);
        for (int k = 0; k <= parts; ++k) {
            const double angle = 2 * halfTurn * k / parts;
            circle.line.push_back(middle + a * std::cos(angle) + b * std::sin(angle));
        }
        out.push_back(std::move(circle));
    }
    return out;
}

static double distanceTo(const Vec3d& a, const Vec3d& b, double px, double py) {
    const double dx = b.x - a.x, dy = b.y - a.y, size = dx * dx + dy * dy;
    const double part = size > 0 ? std::clamp(((px - a.x) * dx + (py - a.y) * dy) / size, 0.0, 1.0) : 0;
    return std::hypot(px - a.x - part * dx, py - a.y - part * dy);
}

std::optional<Handle> handleAt(const render::Camera& camera, const Vec3d& middle, double lengthPx, double px, double py,
                               double reachPx) {
    std::optional<Handle> out;
    double nearest = reachPx;
    for (const HandleShape& shape : handleShapes(camera, middle, lengthPx))
        for (std::size_t i = 0; i < shape.line.size(); i += 1) {
            const Vec3d a = camera.project(shape.line[i]),
                        b = camera.project(shape.line[std::min(i + 1, shape.line.size() - 1)]);
            const double away = distanceTo(a, b, px, py);
            if (a.z > 0 && b.z > 0 && away < nearest)
                nearest = away, out = shape.handle;
        }
    return out;
}

// --- drags ---

/// Where along an axis a ray comes nearest to it; nothing where it nearly goes along it.
static std::optional<double> alongAxis(const Vec3d& middle, const Vec3d& axis, const base::Rayd& ray) {
    constexpr double least = 1e-3;
    const double both = dot(axis, ray.direction), apart = 1 - both * both;
    if (apart < least)
        return {};
    const Vec3d from = ray.origin - middle;
    return (dot(from, axis) - both * dot(from, ray.direction)) / apart;
}

static std::optional<Vec3d> onPlane(const Vec3d& middle, const Vec3d& normal, const base::Rayd& ray) {
    const double rise = dot(ray.direction, normal);
    if (std::abs(rise) < 1e-9)
        return {};
    return ray.origin + ray.direction * (dot(middle - ray.origin, normal) / rise) - middle;
}

/// Seen from the edge a ring is a line: then the near side goes along with the pointer.
static double turnedBy(const HandleDrag& drag, const render::Camera& camera, const base::Rayd& from,
                       const base::Rayd& to, double px, double py) {
    constexpr double edge = 0.15;
    const Vec3d axis = axisOf(drag.handle.axis);
    if (std::abs(dot(axis, from.direction)) > edge) {
        const auto a = onPlane(drag.middle, axis, from), b = onPlane(drag.middle, axis, to);
        return a && b ? std::atan2(dot(axis, cross(*a, *b)), dot(*a, *b)) : 0.0;
    }
    const Vec3d way = cross(axis, -camera.forward());
    const double x = dot(way, camera.right()), y = -dot(way, camera.upright());
    constexpr double perRadian = 110; // pixels
    return ((px - drag.fromX) * x + (py - drag.fromY) * y) / perRadian;
}

Placement dragged(const HandleDrag& drag, const render::Camera& camera, double px, double py, bool steps) {
    Placement out = drag.before;
    const base::Rayd from = camera.ray(drag.fromX, drag.fromY), to = camera.ray(px, py);
    switch (drag.handle.kind) {
    case Handle::Kind::Move: {
        const Vec3d axis = axisOf(drag.handle.axis);
        const auto a = alongAxis(drag.middle, axis, from), b = alongAxis(drag.middle, axis, to);
        if (a && b)
            out.move = out.move + axis * (*b - *a);
        break;
    }
    case Handle::Kind::Free: {
        const auto a = onPlane(drag.middle, camera.forward(), from), b = onPlane(drag.middle, camera.forward(), to);
        if (a && b)
            out.move = out.move + (*b - *a);
        break;
    }
    case Handle::Kind::Turn: {
        double angle = turnedBy(drag, camera, from, to, px, py);
        if (steps)
            angle = std::round(angle * 12 / halfTurn) * halfTurn / 12;
        out.turn = (Rotation::about(axisOf(drag.handle.axis), angle) * out.turn).unit();
        break;
    }
    case Handle::Kind::Scale: {
        constexpr double least = 0.01;
        const Vec3d at = camera.project(drag.middle);
        const double before = std::hypot(drag.fromX - at.x, drag.fromY - at.y);
        out.scale *= before > 0 ? std::max(std::hypot(px - at.x, py - at.y) / before, least) : 1;
        if (steps)
            out.scale = std::max(std::round(out.scale * 10) / 10, 0.1);
        break;
    }
    }
    return out;
}

} // namespace ui
