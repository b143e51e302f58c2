#include "core/process/samples/simulated_scan.h"

#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace process {

namespace {

using base::Vec3d;

/// A ball swept along a segment, thick at one end and thin at the other.
struct Limb {
    Vec3d a, b;
    double radiusA, radiusB;
    double distance(const Vec3d& x) const {
        const Vec3d along = b - a;
        const double t = std::clamp(base::dot(x - a, along) / std::max(base::lengthSq(along), 1e-12), 0.0, 1.0);
        return base::distance(x, a + along * t) - (radiusA + (radiusB - radiusA) * t);
    }
};

constexpr Limb figure[] = {
    {{0, -0.45, 0}, {0, -0.10, 0}, 0.46, 0.36},               // body
    {{0, 0.42, 0.02}, {0, 0.46, 0.05}, 0.33, 0.31},           // head
    {{0, 0.34, 0.32}, {0, 0.33, 0.40}, 0.13, 0.10},           // snout
    {{0.20, 0.68, -0.02}, {0.34, 0.92, -0.06}, 0.10, 0.06},   // ears
    {{-0.20, 0.68, -0.02}, {-0.34, 0.92, -0.06}, 0.10, 0.06}, //
    {{0.34, -0.05, 0.10}, {0.58, -0.28, 0.34}, 0.13, 0.09},   // arms
    {{-0.34, -0.05, 0.10}, {-0.58, -0.28, 0.34}, 0.13, 0.09}, //
    {{0.24, -0.78, 0.10}, {0.30, -0.80, 0.46}, 0.17, 0.13},   // legs
    {{-0.24, -0.78, 0.10}, {-0.30, -0.80, 0.46}, 0.17, 0.13}, //
    {{0, -0.70, -0.40}, {0.10, -0.62, -0.66}, 0.11, 0.05},    // tail
};

/// Where the light is swallowed.
constexpr struct {
    Vec3d centre;
    double radius;
} darkSpots[] = {{{0.02, 0.50, 0.37}, 0.06}, {{0.30, -0.30, 0.36}, 0.09}, {{-0.20, -0.40, -0.42}, 0.12}};

/// Negative inside. Smoothly joined (polynomial minimum of I. Quilez), a lower bound of the distance outside.
double figureDistance(const Vec3d& x) {
    constexpr double blend = 0.07;
    double d = figure[0].distance(x);
    for (const Limb& limb : std::span(figure).subspan(1)) {
        const double other = limb.distance(x), h = std::max(blend - std::abs(d - other), 0.0) / blend;
        d = std::min(d, other) - h * h * blend / 4;
    }
    return d;
}

Vec3d figureNormal(const Vec3d& x) {
    constexpr double e = 1e-5;
    const auto slope = [&](const Vec3d& step) { return figureDistance(x + step) - figureDistance(x - step); };
    return base::normalized(Vec3d{slope({e, 0, 0}), slope({0, e, 0}), slope({0, 0, e})});
}

struct View {
    Vec3d towards, right, up; ///< orthonormal; rays run along -towards
    double pixel;             ///< relative size
    Vec3d misplaced, turned;  ///< of the whole view: shift, and small rotation vector
};

std::vector<View> makeViews(std::uint64_t seed) {
    base::Random random(seed);
    std::vector<View> out;
    for (int v = 0; v < 9; ++v) {
        // Seven on a turntable, two from above.
        const double azimuth = v < 7 ? v * 2 * std::numbers::pi / 7 + 0.3 : (v - 7) * std::numbers::pi + 1.1;
        const double elevation = v < 7 ? 0.15 + 0.1 * (v % 2) : 0.95;
        View view;
        view.towards = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                        std::cos(elevation) * std::cos(azimuth)};
        view.right = base::normalized(base::cross(Vec3d{0, 1, 0}, view.towards));
        view.up = base::cross(view.towards, view.right);
        view.pixel = random.uniform(0.8, 1.5);
        view.misplaced = random.unitVector() * 0.0008;
        view.turned = random.unitVector() * 0.0008;
        out.push_back(view);
    }
    return out;
}

constexpr double halfWindow = 1.25;
constexpr double noise = 0.0012;

/// What one ray of a view brings back, if anything.
std::optional<Vec3d> shoot(const View& view, double u, double v, base::Random& random) {
    const Vec3d origin = view.right * u + view.up * v + view.towards * 2;
    double t = 0;
    for (int step = 0; step < 200; ++step) {
        const double d = figureDistance(origin - view.towards * t);
        t += d;
        if (std::abs(d) < 1e-6)
            break;
        if (t > 4)
            return std::nullopt;
    }
    const Vec3d hit = origin - view.towards * t;
    const double facing = base::dot(figureNormal(hit), view.towards);
    if (facing < 0.25 || random.uniform() > 4 * (facing - 0.25) + 0.3)
        return std::nullopt;
    for (const auto& spot : darkSpots)
        if (base::distance(hit, spot.centre) < spot.radius)
            return std::nullopt;
    const Vec3d seen = hit + view.towards * (noise * random.normal());
    return seen + view.misplaced + base::cross(view.turned, seen);
}

/// All points of all views when pixels have this size, in order of views, rows and columns.
std::vector<Vec3d> shootAll(const std::vector<View>& views, double pixel, std::uint64_t seed) {
    std::vector<Vec3d> out;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const double size = pixel * views[v].pixel;
        const std::size_t n = static_cast<std::size_t>(std::ceil(2 * halfWindow / size));
        std::vector<std::vector<Vec3d>> rows(n);
        base::parallelFor(n, 1, [&](std::size_t row) {
            base::Random random(base::mix(seed + v) ^ row);
            for (std::size_t column = 0; column < n; ++column) {
                const auto at = [&](std::size_t i) {
                    return -halfWindow + (static_cast<double>(i) + random.uniform(0.2, 0.8)) * size;
                };
                const double x = at(column), y = at(row);
                if (const auto point = shoot(views[v], x, y, random))
                    rows[row].push_back(*point);
            }
        });
        for (const auto& row : rows)
            out.insert(out.end(), row.begin(), row.end());
    }
    return out;
}

/// `count` of the points, each set of them equally likely, in their order (Knuth's algorithm S).
std::vector<Vec3d> thinned(const std::vector<Vec3d>& points, std::size_t count, std::uint64_t seed) {
    base::Random random(base::mix(seed));
    std::vector<Vec3d> out;
    for (std::size_t i = 0; i < points.size() && out.size() < count; ++i)
        if (random.uniform() * static_cast<double>(points.size() - i) < static_cast<double>(count - out.size()))
            out.push_back(points[i]);
    return out;
}

} // namespace

surfel::SurfelList simulateScan(std::size_t count, std::uint64_t seed) {
    const std::vector<View> views = makeViews(seed);
    // Points grow with the inverse square of the pixel: guess from a coarse scan, then correct.
    double pixel = 0.02;
    std::vector<Vec3d> points = shootAll(views, pixel, seed);
    while (points.size() < count || points.size() > count + count / 10 + 100) {
        const double wanted = 1.03 * static_cast<double>(count) + 10;
        pixel *= std::clamp(std::sqrt(static_cast<double>(points.size()) / wanted), 0.2, 5.0);
        points = shootAll(views, pixel, seed);
    }
    surfel::SurfelList out;
    for (const Vec3d& p : thinned(points, count, seed)) {
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        out.items.push_back(s);
    }
    return out;
}

} // namespace process
