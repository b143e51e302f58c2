// Sheets near each other with exact normals and known distances, turned anywhere: stacks of walls and wedges, sampled
// off any grid. One spacing is 1; a support is 3.5.
#pragma once

#include "surface/shapes.h"

namespace near_sheets {

using base::Mat3d, base::Vec3d;

struct Roughness {
    double jitter = 0.3; ///< within the sheet
    double noise = 0;    ///< across it, standard deviation
};

struct Scene {
    surfel::SurfelList list;
    std::function<double(const Vec3d&)> distance; ///< above zero outside
    std::function<std::pair<Vec3d, Vec3d>(base::Random&)>
        draw; ///< a place on the surface, not near its rim, and normal
    Mat3d turn;

    surface::Surface surface(surface::SurfaceDefinition definition = {}) const {
        definition.boundary = surface::Boundary::None;
        return shapes::surfaceOf(list, definition);
    }
};

inline Scene emptyScene(base::Random& random) {
    Scene out;
    const Vec3d a = random.unitVector(), b = base::normalized(cross(a, random.unitVector()));
    const Vec3d c = cross(a, b);
    out.turn = {{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}};
    out.list.layout = shapes::layout(true, true);
    return out;
}

constexpr double half = 14; ///< of a scene

/// Samples of the plane through `from` spanned by `along` and the y axis, for u in [lo, hi] of the first.
inline void addWall(Scene& scene, base::Random& random, const Vec3d& from, const Vec3d& along, const Vec3d& normal,
                    double lo, double hi, const Roughness& rough) {
    const double startU = random.uniform(), startV = random.uniform();
    for (double i = std::floor(lo) - 1; i <= hi + 1; ++i)
        for (double j = -half; j <= half; ++j) {
            const double u = i + startU + random.uniform(-rough.jitter, rough.jitter);
            const double v = j + startV + random.uniform(-rough.jitter, rough.jitter);
            const double off = rough.noise * random.normal();
            if (u >= lo && u <= hi)
                scene.list.items.push_back(shapes::surfelAt(
                    scene.turn * (from + along * u + Vec3d{0, v, 0} + normal * off), scene.turn * normal, 3.5));
        }
}

/// Walls at those heights, ascending, that face down and up in turns: solid between the first two, and so on.
inline Scene stack(const std::vector<double>& heights, base::Random& random, const Roughness& rough = {}) {
    Scene out = emptyScene(random);
    const auto facing = [](std::size_t i) { return Vec3d{0, 0, i % 2 == 0 ? -1.0 : 1.0}; };
    for (std::size_t i = 0; i < heights.size(); ++i)
        addWall(out, random, {0, 0, heights[i]}, {1, 0, 0}, facing(i), -half, half, rough);
    const Mat3d turn = out.turn, back = transposed(turn);
    out.distance = [=](const Vec3d& x) {
        const double height = (back * x).z;
        double nearest = 1e300;
        bool outside = true;
        for (const double each : heights) {
            nearest = std::min(nearest, std::abs(height - each));
            outside = outside == (height < each);
        }
        return outside ? nearest : -nearest;
    };
    out.draw = [=](base::Random& r) {
        const std::size_t i = r.below(heights.size());
        return std::pair(turn * Vec3d{r.uniform(-7, 7), r.uniform(-7, 7), heights[i]}, turn * facing(i));
    };
    return out;
}

/// A solid blade of `angle` about the y axis, or the groove that it leaves; its walls begin where they are `thickness`
/// apart.
inline Scene wedge(double angle, double thickness, bool groove, base::Random& random, const Roughness& rough = {}) {
    Scene out = emptyScene(random);
    const double c = std::cos(angle / 2), s = std::sin(angle / 2), side = groove ? -1 : 1;
    const double begin = thickness / (2 * s);
    const Vec3d along[2] = {{c, 0, s}, {c, 0, -s}}, normal[2] = {{-s, 0, c}, {-s, 0, -c}};
    for (int k = 0; k < 2; ++k)
        addWall(out, random, {}, along[k], normal[k] * side, begin, begin + 20, rough);
    const Mat3d turn = out.turn, back = transposed(turn);
    const auto inner = [=](const Vec3d& x) { // above zero outside of the blade
        const Vec3d p = back * x;
        const double heights[2] = {dot(p, normal[0]), dot(p, normal[1])};
        if (std::max(heights[0], heights[1]) < 0)
            return std::max(heights[0], heights[1]);
        double nearest = std::hypot(p.x, p.z);
        for (int k = 0; k < 2; ++k)
            if (dot(p, along[k]) > 0)
                nearest = std::min(nearest, std::abs(heights[k]));
        return nearest;
    };
    out.distance = [=](const Vec3d& x) { return side * inner(x); };
    const Vec3d flank[2] = {along[0], along[1]}, facing[2] = {normal[0] * side, normal[1] * side};
    out.draw = [=](base::Random& r) {
        const std::size_t k = r.below(2);
        const Vec3d p = flank[k] * (begin + r.uniform(1, 8)) + Vec3d{0, r.uniform(-7, 7), 0};
        return std::pair(turn * p, turn * facing[k]);
    };
    return out;
}

} // namespace near_sheets
