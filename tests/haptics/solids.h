// Models with a signed distance that everybody can check: what a tool should feel of them in closed form.
#pragma once

#include "surface/shapes.h"

#include <functional>
#include <string>
#include <vector>

namespace haptics_test {

using base::Vec3d;

struct Solid {
    std::string name;
    surface::Surface surface;
    double unit;                                  ///< h
    double size;                                  ///< a box of so much to each side has what is touched
    std::function<double(const Vec3d&)> distance; ///< positive outside
    std::function<Vec3d(const Vec3d&)> outward;   ///< its gradient
    Vec3d outside;                                ///< a place to begin
};

inline Solid plane(double unit = 0.14) {
    return {"plane",
            shapes::surfaceOf(shapes::plane(40, unit / 3.5, unit)),
            unit,
            0.6,
            [](const Vec3d& x) { return x.z; },
            [](const Vec3d&) {
                return Vec3d{0, 0, 1};
            },
            {0, 0, 0.3}};
}

inline Solid sphere(std::size_t count = 8000) {
    const double unit = 3.5 * shapes::sphereSpacing(count, 1);
    return {"sphere",
            shapes::surfaceOf(shapes::sphere(count, 1, unit)),
            unit,
            1.3,
            [](const Vec3d& x) { return length(x) - 1; },
            [](const Vec3d& x) { return base::normalized(x); },
            {0, 0, 1.2}};
}

inline Solid torus(double spacing = 0.03) {
    const auto ring = [](const Vec3d& x) { return base::normalized(Vec3d{x.x, x.y, 0}, {1, 0, 0}); };
    return {"torus",
            shapes::surfaceOf(shapes::torus(1, 0.4, spacing, 3.5 * spacing)),
            3.5 * spacing,
            1.5,
            [ring](const Vec3d& x) { return length(x - ring(x)) - 0.4; },
            [ring](const Vec3d& x) {
                return base::normalized(x - ring(x), {0, 0, 1});
            },
            {0, 0, 0.8}};
}

/// About the z axis, without ends in reach.
inline Solid cylinder(double spacing = 0.03) {
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    const int columns = static_cast<int>(std::lround(2 * shapes::pi * 0.5 / spacing)), rows = 80;
    for (int i = -rows; i <= rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double a = 2 * shapes::pi * (j + 0.5 * (i & 1)) / columns;
            const Vec3d n{std::cos(a), std::sin(a), 0};
            list.items.push_back(shapes::surfelAt(n * 0.5 + Vec3d{0, 0, i * spacing}, n, 3.5 * spacing));
        }
    return {"cylinder",
            shapes::surfaceOf(list),
            3.5 * spacing,
            0.8,
            [](const Vec3d& x) { return std::hypot(x.x, x.y) - 0.5; },
            [](const Vec3d& x) {
                return base::normalized(Vec3d{x.x, x.y, 0}, {1, 0, 0});
            },
            {0.8, 0, 0}};
}

/// Made once.
inline const std::vector<Solid>& solids() {
    static const std::vector<Solid> all{plane(), sphere(), torus(), cylinder()};
    return all;
}

/// The same with a few thousand points, of spacings up to a fifth of the radius. Made once.
inline const std::vector<Solid>& coarseSolids() {
    static const std::vector<Solid> all{plane(0.3), sphere(500), torus(0.05), cylinder(0.08)};
    return all;
}

/// Nearest place of the solid's surface; exact for these shapes near it.
inline Vec3d onto(const Solid& solid, const Vec3d& x) {
    return x - solid.outward(x) * solid.distance(x);
}

} // namespace haptics_test
