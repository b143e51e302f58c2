// The oracle of ray tests: float64 marching with steps far below the spacing and plain bisection, made of evaluations
// and nearest surfels alone.
#pragma once

#include "core/surface/rays/intersect.h"

#include <optional>

namespace dense {

using base::Vec3d, base::Vec3f;
using surface::Evaluationd, surface::Need, surface::Status, surface::Surface;

constexpr double stepOfUnit = 1.0 / 40;

inline bool usable(const Evaluationd& e) {
    return e.ok() || e.status == Status::BeyondBoundary;
}

/// How far x is from the ball of radius surfaceReach * h about the nearest surfel: at most 0 where surface may be.
inline double beyondReach(const Surface& surface, const Vec3d& x) {
    static thread_local std::vector<tree::Neighbour> found;
    surface.tree().nearest(base::cast<float>(x), 1, found);
    const float support = found[0].block->support(found[0].slot);
    return std::sqrt(double(found[0].distanceSq)) - double(surfel::surfaceReach * support);
}

inline bool isSurface(const Evaluationd& e) {
    return e.ok() && dot(e.normal, e.gradient) >= surface::minSlope && e.offCentre <= surface::maxOffCentre * e.unit;
}

/// The root of the transported f between two samples by bisection, where it is surface; its t. Cracks count as closed:
/// steps of f up to 0.1 h along the slope of both sides, whose normals agree.
inline std::optional<double> rootBetween(const Surface& surface, const base::Rayd& ray, double a, const Evaluationd& ea,
                                         double signA, double b) {
    const double fa = ea.value * signA;
    Vec3d normal = ea.normal * signA;
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (a + b);
        const Evaluationd e = surface.evaluateReference(ray.at(t), Need::Value);
        if (!usable(e))
            return std::nullopt;
        const double sign = dot(e.normal, normal) < 0 ? -1 : 1;
        if ((e.value * sign < 0) == (fa < 0)) {
            a = t;
            normal = e.normal * sign;
        } else {
            b = t;
        }
    }
    const Evaluationd at = surface.evaluateReference(ray.at(a), Need::Gradient);
    Evaluationd beyond = surface.evaluateReference(ray.at(b), Need::Gradient);
    if (dot(at.normal, beyond.normal) < 0)
        beyond.normal = -beyond.normal, beyond.value = -beyond.value;
    const double step = beyond.value - at.value;
    const bool closed = std::abs(step) <= 0.1 * at.unit && dot(at.normal, beyond.normal) >= 0.9 &&
                        dot(at.normal, ray.direction) * step > 0 && dot(beyond.normal, ray.direction) * step > 0;
    if (!isSurface(at) || (std::abs(at.value) > 1e-9 * at.unit && !closed))
        return std::nullopt;
    return 0.5 * (a + b);
}

/// All roots in [from, to], or the first; `within` the balls where surface may be, or wherever f is defined.
inline std::vector<double> hits(const Surface& surface, const base::Rayd& ray, double from, double to,
                                bool firstOnly = false, bool within = true) {
    std::vector<double> out;
    const auto [enter, leave] = base::clip(
        ray, base::Box3d{base::cast<double>(surface.tree().bounds().lo), base::cast<double>(surface.tree().bounds().hi)}
                 .inflated(double(surface.tree().maxSupport())));
    bool known = false;
    double last = 0, sign = 1;
    Evaluationd before;
    for (double t = std::max(from, enter); t <= std::min(to, leave);) {
        const double away = beyondReach(surface, ray.at(t));
        if (away > (within ? 0.0 : 0.3 * double(surface.tree().maxSupport()))) {
            known = false;
            t += std::max(away, 1e-3 * double(surface.tree().maxSupport()));
            continue;
        }
        const Evaluationd e = surface.evaluateReference(ray.at(t), Need::Value);
        if (usable(e)) {
            const double next = known && dot(e.normal, before.normal) * sign < 0 ? -1 : 1;
            const bool oriented = surface.tree().layout()->normals && surface.tree().layout()->oriented;
            const double signNow = oriented ? 1 : next;
            if (known && (before.value * sign < 0) != (e.value * signNow < 0))
                if (const auto root = rootBetween(surface, ray, last, before, sign, t)) {
                    out.push_back(*root);
                    if (firstOnly)
                        return out;
                }
            sign = signNow;
        }
        known = usable(e);
        before = e;
        last = t;
        t += stepOfUnit * (e.unit > 0 ? e.unit : double(surface.tree().maxSupport()));
    }
    return out;
}

} // namespace dense
