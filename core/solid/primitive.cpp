#include "core/solid/primitive.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"

#include <numbers>

namespace solid {

using base::Vec3d;
using std::numbers::pi;

namespace {

double ball(const Size& size, const Vec3d& q) {
    return length(q) - size[0];
}

double box(const Size& size, const Vec3d& q) {
    const Vec3d d{std::abs(q.x) - 0.5 * size[0], std::abs(q.y) - 0.5 * size[1], std::abs(q.z) - 0.5 * size[2]};
    const Vec3d out{std::max(d.x, 0.0), std::max(d.y, 0.0), std::max(d.z, 0.0)};
    return length(out) + std::min(std::max({d.x, d.y, d.z}), 0.0);
}

double cylinder(const Size& size, const Vec3d& q) {
    const double r = std::hypot(q.x, q.y) - size[0], z = std::abs(q.z) - 0.5 * size[1];
    return std::hypot(std::max(r, 0.0), std::max(z, 0.0)) + std::min(std::max(r, z), 0.0);
}

/// Apex up: a triangle of (r, z), of which the side and the base count.
double cone(const Size& size, const Vec3d& q) {
    const double radius = size[0], height = size[1], r = std::hypot(q.x, q.y), z = q.z + 0.5 * height;
    const double slant = std::hypot(radius, height);
    const double side = (height * (r - radius) + radius * z) / slant; // height over the slanting line
    const double along = std::clamp((radius * (radius - r) + height * z) / slant, 0.0, slant);
    const double toSide = std::hypot(r - radius + radius * along / slant, z - height * along / slant);
    const double toBase = std::hypot(std::max(r - radius, 0.0), z);
    return side <= 0 && z >= 0 ? std::max(side, -z) : std::min(toSide, toBase);
}

double torus(const Size& size, const Vec3d& q) {
    return std::hypot(std::hypot(q.x, q.y) - size[0], q.z) - size[1];
}

double capsule(const Size& size, const Vec3d& q) {
    const double half = 0.5 * size[1];
    return distance(q, {0, 0, std::clamp(q.z, -half, half)}) - size[0];
}

} // namespace

std::span<const PrimitiveRow> primitiveTable() {
    static constexpr PrimitiveRow rows[] = {
        {"ball", "Ball", "radius", 1, ball, [](const Size& s) { return 4 * pi / 3 * s[0] * s[0] * s[0]; }},
        {"box", "Box", "three edges", 3, box, [](const Size& s) { return s[0] * s[1] * s[2]; }},
        {"cylinder", "Cylinder", "radius,height", 2, cylinder, [](const Size& s) { return pi * s[0] * s[0] * s[1]; }},
        {"cone", "Cone", "radius,height", 2, cone, [](const Size& s) { return pi / 3 * s[0] * s[0] * s[1]; }},
        {"torus", "Torus", "radius,tube", 2, torus, [](const Size& s) { return 2 * pi * pi * s[0] * s[1] * s[1]; }},
        {"capsule", "Capsule", "radius,length between its balls", 2, capsule,
         [](const Size& s) { return pi * s[0] * s[0] * s[1] + 4 * pi / 3 * s[0] * s[0] * s[0]; }},
    };
    return rows;
}

const PrimitiveRow& primitive(std::string_view id) {
    return base::rowOf(primitiveTable(), id, {"unknown shape \"%\"", "", "known are %"}, &PrimitiveRow::id);
}

Pose poseAlong(const Vec3d& middle, const Vec3d& axis) {
    const Vec3d u = base::perpendicular(axis), v = cross(axis, u);
    return {{{{u.x, v.x, axis.x}, {u.y, v.y, axis.y}, {u.z, v.z, axis.z}}}, middle};
}

/// By differences: exact to 1e-9 but within 1e-5 of an edge.
SideValue PrimitiveSide::at(const Vec3d& x) const {
    const Vec3d q = m_pose.local(x);
    const double step = 1e-5 * *std::max_element(m_size.begin(), m_size.end());
    Vec3d gradient;
    for (std::size_t k = 0; k < 3; ++k) {
        Vec3d up = q, down = q;
        up[k] += step, down[k] -= step;
        gradient[k] = m_row.distance(m_size, up) - m_row.distance(m_size, down);
    }
    return {m_row.distance(m_size, q), normalized(m_pose.turn * gradient), true};
}

/// Of an exact distance.
static SideFoot footBelow(const Vec3d& x, const SideValue& at) {
    return {x - at.gradient * at.value, at.value, at.gradient, true};
}

SideFoot PrimitiveSide::foot(const Vec3d& x) const {
    return footBelow(x, at(x));
}

SideFoot HalfSpaceSide::foot(const Vec3d& x) const {
    return footBelow(x, at(x));
}

bool PrimitiveSide::meets(const base::Box3d& box) const {
    return std::abs(m_row.distance(m_size, m_pose.local(box.centre()))) <= 0.5 * box.diagonal() * (1 + 1e-9);
}

bool HalfSpaceSide::meets(const base::Box3d& box) const {
    return std::abs(dot(m_normal, box.centre()) - m_offset) <= 0.5 * box.diagonal() * (1 + 1e-9);
}

} // namespace solid
