// Boxes as cameras see them.
#pragma once

#include "core/base/random.h"
#include "core/render/camera.h"
#include "core/render/view_frame.h"

#include <algorithm>
#include <limits>

namespace test {

inline base::Vec3d corner(const base::Box3f& box, int k) {
    return {k & 1 ? box.hi.x : box.lo.x, k & 2 ? box.hi.y : box.lo.y, k & 4 ? box.hi.z : box.lo.z};
}

/// How much of half the image the corners reach, 1 where one lies on the image's edge; NaN where one lies behind the
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

/// Do the screen bounds of the box with `reach` around it hold places at its corners that are in the picture? Adds to
/// `seen` how many are.
inline bool boundsHold(const render::Camera& camera, const base::Box3f& box, float reach, base::Random& random,
                       int& seen) {
    const render::ScreenBounds bounds = screenBounds(render::ViewFrame(camera), box, reach);
    bool hold = true;
    for (int c = 0; c < 8; ++c) {
        const base::Vec3d place = camera.project(corner(box, c) + random.unitVector() * (0.999 * reach));
        const int column = static_cast<int>(std::floor(place.x)), row = static_cast<int>(std::floor(place.y));
        if (place.z <= 0 || column < 0 || column >= camera.width || row < 0 || row >= camera.height)
            continue;
        ++seen;
        hold = hold && bounds.visible && column >= bounds.left && column <= bounds.right && row >= bounds.top &&
               row <= bounds.bottom && place.z >= bounds.nearest - 1e-4 * (1 + std::abs(place.z));
    }
    return hold;
}

} // namespace test
