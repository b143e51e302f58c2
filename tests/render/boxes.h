// Boxes as cameras see them.
#pragma once

#include "ui/render/camera.h"

#include <algorithm>
#include <limits>

namespace test {

inline base::Vec3d corner(const base::Box3f& box, int k) {
    return {k & 1 ? box.hi.x : box.lo.x, k & 2 ? box.hi.y : box.lo.y, k & 4 ? box.hi.z : box.lo.z};
}

/// How much of half the image the corners reach, 1 where one lies on the image's rim; NaN where one lies behind the
/// eye.
inline double filledBy(const render::Camera& camera, const base::Box3f& box) {
    double fill = 0;
    for (int c = 0; c < 8; ++c) {
        const base::Vec3d place = camera.project(corner(box, c));
        if (!(place.z > 0))
            return std::numeric_limits<double>::quiet_NaN();
        fill = std::max({fill, std::abs(2 * place.x / camera.width - 1), std::abs(2 * place.y / camera.height - 1)});
    }
    return fill;
}

} // namespace test
