// Rays that start so far away that single precision tells little of the model along them: they begin anew before its
// bounds, in doubles, and what is found is counted from where they began. Internal to the room.
#pragma once

#include "core/surface/rays/ray_probe.h"

#include <optional>

namespace surface {

template <class T>
struct FarRay {
    RaySetting setting; ///< with tMin and tMax counted from the new start
    base::Ray<T> ray;
    double skipped; ///< from the old start to the new one
};

/// Nothing where the ray starts near by. A ray that misses the bounds, or whose start is so far that doubles do not
/// tell the model's place on it, comes back without a direction, and has no hit.
template <class T>
std::optional<FarRay<T>> farRay(const RaySetting& setting, const base::Ray<T>& ray) {
    constexpr double far = 100, near = 4; // diagonals of the bounds
    const base::Box3d box{base::cast<double>(setting.bounds.lo), base::cast<double>(setting.bounds.hi)};
    const double diagonal = box.diagonal();
    const base::Rayd exact{base::cast<double>(ray.origin), base::normalized(base::cast<double>(ray.direction))};
    if (!setting.any || !(distance(exact.origin, box.centre()) > far * diagonal))
        return {};
    FarRay<T> out{setting, ray, 0};
    const auto [first, last] = base::clip(exact, box);
    const base::Vec3d start = exact.at(first);
    if (!(first <= last) || !(distance(start, box.centre()) < near * diagonal)) {
        out.ray.direction = {};
        return out;
    }
    out.ray.origin = base::cast<T>(start);
    out.skipped = first;
    out.setting.options.tMin = static_cast<float>(std::max(0.0, double(setting.options.tMin) - first));
    out.setting.options.tMax = static_cast<float>(double(setting.options.tMax) - first);
    return out;
}

} // namespace surface
