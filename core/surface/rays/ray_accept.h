// Which roots are surface (surface/README 4.4), and what a hit tells. Internal to the room.
#pragma once

#include "core/surface/rays/ray_probe.h"

#include <optional>

namespace surface {

/// The hit at t with what an evaluation at most a tolerance away tells.
template <class T>
void hitAt(RayProbe<T>& probe, double t, const Evaluation<T>& at, const base::Vec3<T>& gradient, RayHit<T>& out) {
    out.hit = true;
    out.t = static_cast<T>(t);
    out.position = base::cast<T>(probe.position(t));
    out.outward = base::normalized(gradient);
    out.normal = dot(out.outward, base::cast<T>(probe.direction())) > T(0) ? -out.outward : out.outward;
    out.unit = at.unit;
    out.agreement = at.agreement;
    out.evaluations = probe.takeEvaluations();
}
template <class T>
RayHit<T> hitAt(RayProbe<T>& probe, double t, const Evaluation<T>& at, const base::Vec3<T>& gradient) {
    RayHit<T> out;
    hitAt(probe, t, at, gradient, out);
    return out;
}

/// A place where f changes its sign.
struct RayRoot {
    double t = 0;
    double step = 0; ///< what f jumps by there, where the surface has a crack that counts as closed
};

/// The root, if it is surface in [tMin, tMax], and f no jump but a crack.
template <class T>
std::optional<RayHit<T>> accept(RayProbe<T>& probe, const RayRoot& root) {
    if (!probe.inRange(root.t))
        return std::nullopt;
    const Evaluation<T> at = probe.sample(root.t, Need::Gradient).at;
    if (!isSurface(at) || std::abs(double(at.value)) > std::max(10 * probe.tolerance(at, root.t), root.step))
        return std::nullopt;
    return hitAt(probe, root.t, at, at.gradient);
}

} // namespace surface
