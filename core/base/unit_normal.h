// Normals that come from elsewhere, made unit length without changing those that are.
#pragma once

#include "core/base/vec.h"

namespace base {

/// How far the squared length of a float vector of unit length may be from 1 by rounding.
constexpr float unitTolerance = 2e-6f;

/// `n` bit for bit where its length is 1 as far as rounding can tell, else scaled in double; zero without a direction.
inline Vec3f unitNormal(const Vec3f& n) {
    if (std::abs(lengthSq(n) - 1.0f) <= unitTolerance)
        return n;
    return cast<float>(normalized(cast<double>(n)));
}

} // namespace base
