// Directions that rays of light take from the points of a picture: a few from each point, and from sixteen neighbours
// together many that cover the lamp or the sky evenly (raycast/README 4.5). Fixed, so that pictures need no seed.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <numbers>

namespace raycast {

/// Which of the sixteen patterns a pixel takes: Bayer's matrix, in which near pixels differ most.
inline int patternOf(int column, int row) {
    const int x = column & 3, y = row & 3, e = x ^ y;
    return (e & 1) << 3 | (y & 1) << 2 | (e & 2) | (y & 2) >> 1;
}
constexpr int patternCount = 16;

/// Point j of `count` in the unit square: Roberts' additive sequence (2018), any run of which is evenly spread. A
/// pattern takes a run; all patterns one after the other take a longer one.
struct UnitSquarePoint {
    float u = 0, v = 0;
};
inline UnitSquarePoint unitSquarePoint(int pattern, int j, int count) {
    const double i = pattern * count + j + 1, a = 0.7548776662466927 * i, b = 0.5698402909980532 * i;
    return {static_cast<float>(a - std::floor(a)), static_cast<float>(b - std::floor(b))};
}

/// A unit direction around the axis, evenly over the disc of radius `sine`: sine 1 gives the hemisphere with the
/// density of the cosine, smaller ones a round lamp.
inline base::Vec3f around(const base::Vec3f& axis, const UnitSquarePoint& point, float sine) {
    const float r = sine * std::sqrt(point.u), angle = 2 * std::numbers::pi_v<float> * point.v;
    const base::Vec3f a = base::perpendicular(axis), b = cross(axis, a);
    return a * (r * std::cos(angle)) + b * (r * std::sin(angle)) + axis * std::sqrt(std::max(0.0f, 1 - r * r));
}

} // namespace raycast
