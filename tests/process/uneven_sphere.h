// A model whose density varies by as much as a scan's does.
#pragma once

#include "core/base/random.h"
#include "core/surfel/surfel.h"

#include <cmath>

namespace shapes {

inline surfel::Surfel at(const base::Vec3d& p) {
    surfel::Surfel s;
    s.position = base::cast<float>(p);
    return s;
}

/// Random samples of the unit sphere, 20 times as far apart at the upper end as at the lower.
inline surfel::SurfelList unevenSphere(std::size_t count, base::Random& random) {
    surfel::SurfelList out;
    while (out.size() < count)
        if (const base::Vec3d d = random.unitVector(); random.uniform() < std::pow(20.0, -1 - d.z))
            out.items.push_back(at(d));
    return out;
}

} // namespace shapes
