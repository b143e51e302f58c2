// Rotations as unit quaternions: w + (x, y, z). Plain values, float64.
#pragma once

#include "core/base/vec.h"

#include <algorithm>

namespace ui {

struct Rotation {
    double w = 1;
    base::Vec3d v;

    bool operator==(const Rotation&) const = default;

    /// About a unit axis, by the right-hand rule.
    static Rotation about(const base::Vec3d& axis, double angleRad) {
        return {std::cos(0.5 * angleRad), axis * std::sin(0.5 * angleRad)};
    }
    /// Takes x, y, z to these (orthonormal, right-handed) axes.
    static Rotation toAxes(const base::Vec3d& x, const base::Vec3d& y, const base::Vec3d& z) {
        const double trace = x.x + y.y + z.z; // [Shepperd78]: from the largest component
        Rotation out;
        if (trace > 0)
            out = {1 + trace, {y.z - z.y, z.x - x.z, x.y - y.x}};
        else if (x.x >= y.y && x.x >= z.z)
            out = {y.z - z.y, {1 + x.x - y.y - z.z, y.x + x.y, z.x + x.z}};
        else if (y.y >= z.z)
            out = {z.x - x.z, {y.x + x.y, 1 + y.y - x.x - z.z, z.y + y.z}};
        else
            out = {x.y - y.x, {z.x + x.z, z.y + y.z, 1 + z.z - x.x - y.y}};
        return out.unit();
    }

    Rotation inverse() const { return {w, -v}; }
    Rotation unit() const {
        const double size = std::sqrt(w * w + lengthSq(v));
        return {w / size, v / size};
    }
    /// First `o`, then this.
    Rotation operator*(const Rotation& o) const { return {w * o.w - dot(v, o.v), o.v * w + v * o.w + cross(v, o.v)}; }
    base::Vec3d operator()(const base::Vec3d& p) const {
        const base::Vec3d t = cross(v, p) * 2.0;
        return p + t * w + cross(v, t);
    }

    /// From a to b at constant angular speed, the shorter way [Shoemake85].
    static Rotation between(const Rotation& a, Rotation b, double part) {
        double cosine = a.w * b.w + dot(a.v, b.v);
        if (cosine < 0)
            cosine = -cosine, b = {-b.w, -b.v};
        const double angle = std::acos(std::min(cosine, 1.0)), sine = std::sin(angle);
        if (sine < 1e-6)
            return Rotation{a.w + (b.w - a.w) * part, a.v + (b.v - a.v) * part}.unit();
        const double from = std::sin((1 - part) * angle) / sine, to = std::sin(part * angle) / sine;
        return Rotation{a.w * from + b.w * to, a.v * from + b.v * to}.unit();
    }
};

} // namespace ui
