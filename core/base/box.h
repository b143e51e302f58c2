// Axis-aligned boxes. The default box is empty (lo = +inf, hi = -inf) and extending it with a point makes it that
// point.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <limits>

namespace base {

template <class T>
struct Box3 {
    static constexpr T inf = std::numeric_limits<T>::infinity();
    Vec3<T> lo{inf, inf, inf};
    Vec3<T> hi{-inf, -inf, -inf};

    constexpr bool operator==(const Box3&) const = default;
    constexpr bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    constexpr Vec3<T> centre() const { return (lo + hi) * T(0.5); }
    constexpr Vec3<T> size() const { return empty() ? Vec3<T>{} : hi - lo; }
    T diagonal() const { return length(size()); }

    constexpr void extend(const Vec3<T>& p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    constexpr void extend(const Box3& b) {
        if (!b.empty())
            extend(b.lo), extend(b.hi);
    }
    constexpr Box3 inflated(T by) const {
        return empty() ? *this : Box3{lo - Vec3<T>{by, by, by}, hi + Vec3<T>{by, by, by}};
    }
    /// What both have; empty where they do not meet.
    constexpr Box3 cut(const Box3& b) const {
        return {{std::max(lo.x, b.lo.x), std::max(lo.y, b.lo.y), std::max(lo.z, b.lo.z)},
                {std::min(hi.x, b.hi.x), std::min(hi.y, b.hi.y), std::min(hi.z, b.hi.z)}};
    }
    constexpr bool contains(const Vec3<T>& p) const {
        return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
    }
    constexpr bool overlaps(const Box3& b) const {
        return lo.x <= b.hi.x && hi.x >= b.lo.x && lo.y <= b.hi.y && hi.y >= b.lo.y && lo.z <= b.hi.z && hi.z >= b.lo.z;
    }
    /// Squared distance from `p` to the nearest point of the box; 0 inside, +inf for the empty box.
    constexpr T distanceSq(const Vec3<T>& p) const {
        if (empty())
            return inf;
        const Vec3<T> q{std::clamp(p.x, lo.x, hi.x), std::clamp(p.y, lo.y, hi.y), std::clamp(p.z, lo.z, hi.z)};
        return base::distanceSq(p, q);
    }
};

using Box3f = Box3<float>;
using Box3d = Box3<double>;

} // namespace base
