// Directions that places of a picture look into: of each place a few, of sixteen neighbours together many that cover
// the lamp or the sky evenly. Fixed, so that pictures never depend on a seed.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <numbers>

namespace raycast {

/// Which of the sixteen patterns a pixel takes: Bayer's, so that near pixels differ most.
inline int patternOf(int column, int row) {
    const int x = column & 3, y = row & 3, e = x ^ y;
    return (e & 1) << 3 | (y & 1) << 2 | (e & 2) | (y & 2) >> 1;
}
constexpr int patterns = 16;

/// Place j of `count` in the unit square: the additive sequence of Roberts (2018), any run of which is even. A pattern
/// takes a run; all patterns one after the other take a longer one.
struct UnitPlace {
    float u = 0, v = 0;
};
inline UnitPlace unitPlace(int pattern, int j, int count) {
    const double i = pattern * count + j + 1, a = 0.7548776662466927 * i, b = 0.5698402909980532 * i;
    return {static_cast<float>(a - std::floor(a)), static_cast<float>(b - std::floor(b))};
}

/// Around the unit axis, evenly over the disc of radius `sine` seen from its foot: sine 1 is the hemisphere with the
/// density of the cosine, smaller ones are round lamps.
inline base::Vec3f around(const base::Vec3f& axis, const UnitPlace& place, float sine) {
    const float r = sine * std::sqrt(place.u), angle = 2 * std::numbers::pi_v<float> * place.v;
    const base::Vec3f a = base::perpendicular(axis), b = cross(axis, a);
    return a * (r * std::cos(angle)) + b * (r * std::sin(angle)) + axis * std::sqrt(std::max(0.0f, 1 - r * r));
}

} // namespace raycast
