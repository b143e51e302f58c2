#include "core/sculpt/mirror.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sculpt {

using base::Vec3f;

Vec3f Mirror::turned(const Vec3f& d) const {
    Vec3f out = d;
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>(b);
    out[ia] = cosine * d[ia] - sine * d[ib];
    out[ib] = sine * d[ia] + cosine * d[ib];
    return out;
}

base::Mat3f Mirror::matrix() const {
    const Vec3f x1 = direction({1, 0, 0}), y1 = direction({0, 1, 0}), z1 = direction({0, 0, 1});
    return {{{x1.x, y1.x, z1.x}, {x1.y, y1.y, z1.y}, {x1.z, y1.z, z1.z}}};
}

/// Cosine of `step` out of `copies` equal parts of a turn, exact at quarters.
static float cosineOf(int step, int copies) {
    if (4 * step % copies == 0) {
        constexpr float quarters[] = {1, 0, -1, 0};
        return quarters[4 * step / copies % 4];
    }
    return static_cast<float>(std::cos(2 * std::numbers::pi * step / copies));
}

/// The same place for every point: a turn by 180 degrees is a flip at two planes.
static bool same(const Mirror& a, const Mirror& b) {
    for (const Vec3f& unit : {Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}})
        if (distance(a.direction(unit), b.direction(unit)) > 1e-4f)
            return false;
    return true;
}

std::vector<Mirror> mirrors(const Symmetry& symmetry, const base::Vec3d& origin) {
    std::vector<Mirror> out;
    for (int step = 0; step < symmetry.copies; ++step)
        for (int k = 0; k < 8; ++k) {
            const bool x = k & 1, y = k & 2, z = k & 4;
            if ((x && !symmetry.planes.x) || (y && !symmetry.planes.y) || (z && !symmetry.planes.z))
                continue;
            Mirror image{x, y, z, base::cast<float>(-origin), static_cast<int>(symmetry.axis), step};
            image.cosine = cosineOf(step, symmetry.copies);
            // sin(a) = cos(a - 90 degrees), in whole parts of a turn four times as fine
            image.sine = cosineOf(4 * step + 3 * symmetry.copies, 4 * symmetry.copies);
            if (std::none_of(out.begin(), out.end(), [&](const Mirror& other) { return same(image, other); }))
                out.push_back(image);
        }
    return out;
}

} // namespace sculpt
