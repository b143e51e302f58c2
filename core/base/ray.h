// Half lines. `direction` is of unit length, so that `t` is a distance in model units.
#pragma once

#include "core/base/box.h"

#include <utility>

namespace base {

template <class T>
struct Ray {
    Vec3<T> origin;
    Vec3<T> direction;

    Vec3<T> at(T t) const { return origin + direction * t; }
};

using Rayf = Ray<float>;
using Rayd = Ray<double>;

/// Interval of `t >= 0` in which the ray is inside the box; first > second when it misses (Kay & Kajiya slabs).
/// A ray that starts inside begins at 0. Zero direction components are handled by IEEE infinities.
template <class T>
std::pair<T, T> clip(const Ray<T>& ray, const Box3<T>& box) {
    T t0 = T(0), t1 = std::numeric_limits<T>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        if (ray.direction[k] == T(0)) {
            if (ray.origin[k] < box.lo[k] || ray.origin[k] > box.hi[k])
                return {T(1), T(0)};
            continue;
        }
        const T inverse = T(1) / ray.direction[k];
        const T a = (box.lo[k] - ray.origin[k]) * inverse, b = (box.hi[k] - ray.origin[k]) * inverse;
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
    }
    return {t0, t1};
}

} // namespace base
