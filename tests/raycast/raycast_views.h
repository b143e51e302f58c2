// Views of test models, and how an adaptive picture differs from the full cast of the same view.
#pragma once

#include "core/raycast/adaptive_cast.h"

#include <numbers>

namespace views {

using base::Vec3d;

/// A square picture of what lies within `radius` of `centre`, seen along `direction` and filling it: in perspective
/// from five radii away, or with parallel rays.
inline raycast::ImageRays filling(const Vec3d& centre, double radius, const Vec3d& direction, int pixels,
                                  bool parallel = false) {
    const Vec3d forward = normalized(direction), right = base::perpendicular(forward), down = cross(forward, right);
    const double distance = 5, focal = 0.5 * pixels * std::sqrt(distance * distance - 1);
    const Vec3d aside = (right + down) * (0.5 - 0.5 * pixels);
    raycast::ImageRays out;
    out.width = out.height = pixels;
    out.eye = centre - forward * (distance * radius);
    out.corner = forward * focal + aside;
    out.across = right, out.down = down;
    if (parallel) {
        const double unit = 2 * radius / pixels;
        out.eye += aside * unit;
        out.originAcross = right * unit, out.originDown = down * unit;
        out.corner = forward, out.across = out.down = {};
    }
    return out;
}

/// The same view of a model turned by so many degrees about an axis through `centre`.
inline raycast::ImageRays turned(raycast::ImageRays rays, const Vec3d& centre, const Vec3d& axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const Vec3d n = normalized(axis);
    const auto turn = [&](const Vec3d& v) { return v * c + cross(n, v) * s + n * (dot(n, v) * (1 - c)); };
    rays.eye = centre + turn(rays.eye - centre);
    for (Vec3d* v : {&rays.originAcross, &rays.originDown, &rays.corner, &rays.across, &rays.down})
        *v = turn(*v);
    return rays;
}

/// Half the diagonal of the model's box, and its centre.
inline double radiusOf(const surface::Surface& model) {
    return 0.5 * static_cast<double>(model.tree().bounds().diagonal());
}
inline Vec3d centreOf(const surface::Surface& model) {
    return base::cast<double>(model.tree().bounds().centre());
}

struct Difference {
    std::size_t hits = 0;      ///< of the full cast
    std::size_t passed = 0;    ///< of those, within 2 degrees and 0.2 spacings
    std::size_t falseHits = 0; ///< where the full cast has none
    std::size_t lost = 0;      ///< misses where it has one
    double worstAngle = 0, worstDepth = 0;

    double share() const { return hits == 0 ? 1 : static_cast<double>(passed) / static_cast<double>(hits); }
};

inline Difference difference(std::span<const raycast::Sample> samples, std::span<const raycast::Sample> full,
                             double quality = 1) {
    Difference out;
    for (std::size_t i = 0; i < full.size(); ++i) {
        const auto &a = samples[i].hit, &b = full[i].hit;
        out.hits += b.hit ? 1 : 0;
        out.falseHits += a.hit && !b.hit ? 1 : 0;
        out.lost += b.hit && !a.hit ? 1 : 0;
        if (!a.hit || !b.hit)
            continue;
        const double angle = std::acos(std::clamp(static_cast<double>(dot(a.normal, b.normal)), -1.0, 1.0));
        const double depth =
            std::abs(static_cast<double>(a.t) - static_cast<double>(b.t)) / (static_cast<double>(b.unit) / 3.5);
        out.passed += angle <= quality * 2 * std::numbers::pi / 180 && depth <= quality * 0.2 ? 1 : 0;
        out.worstAngle = std::max(out.worstAngle, angle * 180 / std::numbers::pi);
        out.worstDepth = std::max(out.worstDepth, depth);
    }
    return out;
}

inline bool sameBits(const raycast::Sample& a, const raycast::Sample& b) {
    const auto &p = a.hit, &q = b.hit;
    return p.hit == q.hit && a.colour == b.colour && a.mask == b.mask &&
           (!p.hit || (p.t == q.t && p.position == q.position && p.normal == q.normal && p.outward == q.outward &&
                       p.unit == q.unit && p.agreement == q.agreement));
}

} // namespace views
