// Exact shapes as raw points of uneven spacing with exact normals, and distances to them in closed form.
#pragma once

#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/reduce/reduce.h"
#include "core/surface/projection/project.h"

#include <functional>
#include <numbers>

namespace test {

using base::Vec3d;
using base::Vec3f;

struct Shape {
    surface::Surface surface;
    std::function<double(const Vec3d&)> distance; ///< signed, to the exact surface
    double spacing = 0;                           ///< root of the area per sample
    double diagonal = 0;
};

inline surface::Surface prepared(const std::vector<std::pair<Vec3d, Vec3d>>& points, bool normals = true) {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = normals;
    list.layout = layout;
    for (const auto& [p, n] : points) {
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        s.normal = normals ? base::cast<float>(n) : Vec3f{};
        list.append(s, {});
    }
    process::PrepareOptions options;
    return process::prepare(std::move(list), options);
}

/// Golden spiral, each sample shaken by a part of the spacing.
inline std::vector<Vec3d> shakenDirections(std::size_t count, double shake, base::Random& random) {
    std::vector<Vec3d> out;
    const double s = std::sqrt(4 * std::numbers::pi / double(count));
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - 2 * (double(i) + 0.5) / double(count), r = std::sqrt(1 - z * z);
        const double a = double(i) * std::numbers::pi * (3 - std::sqrt(5.0));
        out.push_back(normalized(Vec3d{r * std::cos(a), r * std::sin(a), z} + random.unitVector() * (shake * s)));
    }
    return out;
}

inline Shape sphere(std::size_t count, double shake = 0.3, unsigned long long seed = 1) {
    base::Random random(seed);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    for (const Vec3d& d : shakenDirections(count, shake, random))
        points.push_back({d, d});
    return {prepared(points), [](const Vec3d& x) { return length(x) - 1; },
            std::sqrt(4 * std::numbers::pi / double(count)), std::sqrt(12.0)};
}

/// The upper half of it: open.
inline Shape halfSphere(std::size_t count, double shake = 0.3) {
    base::Random random(2);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    for (const Vec3d& d : shakenDirections(2 * count, shake, random))
        if (d.z > 0)
            points.push_back({d, d});
    return {prepared(points), [](const Vec3d& x) { return length(x) - 1; },
            std::sqrt(2 * std::numbers::pi / double(count)), 3};
}

/// Radii 1 and 0.4 around z.
inline Shape torus(std::size_t count) {
    base::Random random(3);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    while (points.size() < count) {
        const double u = random.uniform(0, 2 * std::numbers::pi), v = random.uniform(0, 2 * std::numbers::pi);
        if (random.uniform(0, 1.4) > 1 + 0.4 * std::cos(v))
            continue;
        const Vec3d n{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
        points.push_back({Vec3d{std::cos(u), std::sin(u), 0} + n * 0.4, n});
    }
    const double area = 4 * std::numbers::pi * std::numbers::pi * 0.4;
    return {prepared(points), [](const Vec3d& x) { return std::hypot(std::hypot(x.x, x.y) - 1, x.z) - 0.4; },
            std::sqrt(area / double(count)), std::sqrt(2 * 2.8 * 2.8 + 0.64)};
}

/// Of radius 1 around z, from -2 to 2: open, straight along one direction.
inline Shape cylinder(std::size_t count) {
    base::Random random(6);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    const double s = std::sqrt(8 * std::numbers::pi / double(count));
    const int around = int(std::lround(2 * std::numbers::pi / s)), along = int(std::lround(4 / s));
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const double z = -2 + 4 * (i + random.uniform(0.2, 0.8)) / along;
            const double u = 2 * std::numbers::pi * (j + 0.5 * (i % 2) + random.uniform(-0.3, 0.3)) / around;
            const Vec3d n{std::cos(u), std::sin(u), 0};
            points.push_back({n + Vec3d{0, 0, z}, n});
        }
    return {prepared(points), [](const Vec3d& x) { return std::hypot(x.x, x.y) - 1; }, s, std::sqrt(24.0)};
}

/// `side` x `side` points in the unit square, shaken; open.
inline Shape plane(int side) {
    base::Random random(4);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            points.push_back(
                {{(i + random.uniform(0.2, 0.8)) / side, (j + random.uniform(0.2, 0.8)) / side, 0}, {0, 0, 1}});
    return {prepared(points), [](const Vec3d& x) { return x.z; }, 1.0 / side, std::sqrt(2.0)};
}

/// Two plates of the unit square, `thick` spacings apart, closed around: the sides are sampled, too.
inline Shape plate(int side, double thick) {
    base::Random random(5);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    const double s = 1.0 / side, t = thick * s;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            for (const double up : {-1.0, 1.0})
                points.push_back(
                    {{(i + random.uniform(0.2, 0.8)) * s, (j + random.uniform(0.2, 0.8)) * s, up * t / 2}, {0, 0, up}});
    const auto outside = [t](const Vec3d& x) {
        return std::abs(std::abs(x.z) - t / 2); // but at the edges
    };
    return {prepared(points), outside, s, std::sqrt(2.0)};
}

/// Root of the mean square of the exact distances of feet, of places near the surface.
struct Errors {
    double rms = 0, max = 0;
    int lost = 0;
};
inline Errors errorsOf(const surface::Surface& surface, const Shape& shape, const std::vector<Vec3f>& places) {
    Errors out;
    double sum = 0;
    std::size_t n = 0;
    for (const Vec3f& x : places) {
        const auto foot = surface::project(surface, x);
        if (!foot.ok()) {
            ++out.lost;
            continue;
        }
        const double d = std::abs(shape.distance(base::cast<double>(foot.foot)));
        sum += d * d, ++n;
        out.max = std::max(out.max, d);
    }
    out.rms = n > 0 ? std::sqrt(sum / double(n)) : 0;
    return out;
}

inline std::vector<Vec3f> positionsOf(const surface::Surface& surface) {
    std::vector<Vec3f> out;
    for (const surfel::Surfel& s : surface.tree().surfels().items)
        out.push_back(s.position);
    return out;
}

/// Every n-th surfel with supports for 12 neighbours: what reducing has to beat.
inline surface::Surface thinned(const surface::Surface& surface, std::size_t count) {
    const surfel::SurfelList all = surface.tree().surfels();
    surfel::SurfelList list;
    list.layout = all.layout;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k * all.size() / count;
        list.append(all.items[i], all.extraOf(i));
    }
    process::PrepareOptions options;
    options.definition = surface.definition();
    options.definition.neighbours = 12;
    options.keepSupports = false;
    return process::prepare(std::move(list), options);
}

} // namespace test
