// An axis as near sheets are parted by, for the sums that take surfels by it.
#pragma once

#include "core/base/random.h"
#include "core/surface/evaluation/moments.h"

namespace test {

/// It points along a unit vector and moves as much as one does within a support or so.
inline surface::Axis movingAxis(const base::Vec3d& at, base::Random& random) {
    surface::Axis out;
    out.at = at;
    for (base::Vec3d& each : out.slope)
        each = random.unitVector() * random.uniform(0, 3);
    for (base::Vec3d& each : out.bend)
        each = random.unitVector() * random.uniform(0, 9);
    return out;
}

} // namespace test
