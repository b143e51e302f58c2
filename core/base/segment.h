// Straight pieces of lines, from one place to another, and what of them is nearest to a place. Those of no length are
// their beginning.
#pragma once

#include "core/base/vec.h"

#include <algorithm>

namespace base {

/// How far along the line through a segment the foot of x is: 0 at `from`, 1 at `to`, and beyond.
template <class T>
T shareAlong(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& x) {
    const Vec3<T> way = to - from;
    return lengthSq(way) > 0 ? dot(x - from, way) / lengthSq(way) : T(0);
}

/// The same of the nearest place of the segment itself: 0 to 1.
template <class T>
T nearestShare(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& x) {
    return std::clamp(shareAlong(from, to, x), T(0), T(1));
}

template <class T>
Vec3<T> nearestOnSegment(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& x) {
    return from + (to - from) * nearestShare(from, to, x);
}

} // namespace base
