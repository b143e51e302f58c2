// What a laser scanner brings back from a scene whose surfaces are known: a ray per place of its grid, a beam that is
// not a line but as wide as a place or so, and noise along it. Where a beam meets two surfaces its range is their mean,
// and the point stands between them: a mixed pixel.
#pragma once

#include "core/base/random.h"
#include "core/surfel/surfel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace scan {

using base::Vec3d;

/// A ball, a box or an upright cylinder with its caps; boxes and cylinders turned about z.
struct Solid {
    enum class Kind { Ball, Box, Cylinder } kind = Kind::Ball;
    Vec3d centre, half{1, 1, 1}; ///< half sizes; of balls and cylinders x is the radius
    double turn = 0;
    double lean = 0; ///< about x, after the turn

    Vec3d local(const Vec3d& v) const {
        const double c = std::cos(turn), s = std::sin(turn), cl = std::cos(lean), sl = std::sin(lean);
        const Vec3d t{c * v.x + s * v.y, c * v.y - s * v.x, v.z};
        return {t.x, cl * t.y + sl * t.z, cl * t.z - sl * t.y};
    }
    /// Along the ray from outside; infinite where it misses.
    double hit(const Vec3d& eye, const Vec3d& way) const {
        const Vec3d o = local(eye - centre), d = local(way);
        double in = -std::numeric_limits<double>::infinity(), out = -in;
        if (kind == Kind::Ball || kind == Kind::Cylinder) {
            const double z = kind == Kind::Ball ? 1 : 0, a = d.x * d.x + d.y * d.y + z * d.z * d.z;
            const double b = o.x * d.x + o.y * d.y + z * o.z * d.z;
            const double c = o.x * o.x + o.y * o.y + z * o.z * o.z - half.x * half.x, root = b * b - a * c;
            if (root < 0 || a == 0)
                return out;
            in = (-b - std::sqrt(root)) / a, out = (-b + std::sqrt(root)) / a;
        }
        for (int k = kind == Kind::Ball ? 3 : kind == Kind::Box ? 0 : 2; k < 3; ++k) {
            const double near = (-half[k] - o[k]) / d[k], far = (half[k] - o[k]) / d[k];
            in = std::max(in, std::min(near, far)), out = std::min(out, std::max(near, far));
        }
        return in <= out && in > 0 ? in : std::numeric_limits<double>::infinity();
    }
    /// From its surface.
    double off(const Vec3d& x) const {
        const Vec3d p = local(x - centre);
        if (kind == Kind::Ball)
            return std::abs(length(p) - half.x);
        Vec3d q{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
        if (kind == Kind::Cylinder)
            q = {std::hypot(p.x, p.y) - half.x, -half.x, q.z};
        const double inside = std::min(std::max({q.x, q.y, q.z}), 0.0);
        return std::abs(inside + length(Vec3d{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)}));
    }
};

struct Scanner {
    Vec3d eye;
    double heading = 0, pitch = 0.008; ///< radians; pitch: between two places of the grid
    int rows = 60, columns = 80;
    double beam = 1.2;  ///< full width, in places of the grid
    double noise = 0.1; ///< along the ray, in places of the grid at range 1
};

struct Scanned {
    surfel::SurfelList points;       ///< with the attributes `row` and `column`
    std::vector<std::uint8_t> mixed; ///< off all surfaces by more than noise, along a beam that met several
    std::vector<std::uint8_t> pure;  ///< of a beam that met one alone
    std::vector<std::uint8_t> solid; ///< what its middle met
};

inline Scanned scanned(const std::vector<Solid>& scene, const Scanner& with, base::Random& random) {
    Scanned out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->add("row", surfel::ScalarType::Int32);
    layout->add("column", surfel::ScalarType::Int32);
    out.points.layout = layout;
    std::vector<std::array<double, 2>> within{{0, 0}};
    for (int ring = 1; ring <= 2; ++ring)
        for (int k = 0; k < 6 * ring; ++k)
            within.push_back(
                {ring / 2.0 * std::cos(k * 1.0471975512 / ring), ring / 2.0 * std::sin(k * 1.0471975512 / ring)});
    const auto wayAt = [&](double row, double column) {
        const double a = with.heading + (column - with.columns / 2.0) * with.pitch,
                     e = (row - with.rows / 2.0) * with.pitch;
        return Vec3d{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    };
    for (int row = 0; row < with.rows; ++row)
        for (int column = 0; column < with.columns; ++column) {
            double sum = 0, count = 0;
            std::vector<std::size_t> met;
            for (const auto& [x, y] : within) {
                const Vec3d way = wayAt(row + y * with.beam / 2, column + x * with.beam / 2);
                double range = std::numeric_limits<double>::infinity();
                std::size_t which = scene.size();
                for (std::size_t k = 0; k < scene.size(); ++k)
                    if (const double t = scene[k].hit(with.eye, way); t < range)
                        range = t, which = k;
                met.push_back(which);
                if (which < scene.size())
                    sum += range, ++count;
            }
            if (count < 5)
                continue; // too little light comes back
            const double error = with.noise * with.pitch * random.normal();
            const Vec3d p = with.eye + wayAt(row, column) * (sum / count + error);
            surfel::Surfel s;
            s.position = base::cast<float>(p);
            out.points.items.push_back(s);
            const std::array<std::uint32_t, 2> words{static_cast<std::uint32_t>(row),
                                                     static_cast<std::uint32_t>(column)};
            out.points.extra.insert(out.points.extra.end(), words.begin(), words.end());
            double off = std::numeric_limits<double>::infinity();
            for (const Solid& each : scene)
                off = std::min(off, each.off(p));
            const bool pure = std::all_of(met.begin(), met.end(), [&](std::size_t k) { return k == met[0]; });
            out.pure.push_back(pure);
            out.mixed.push_back(!pure && off > with.pitch * (4 * with.noise + sum / count));
            out.solid.push_back(static_cast<std::uint8_t>(met[0]));
        }
    return out;
}

/// Balls, boxes, cylinders and wires on a floor before a wall, at ranges of 3 to 9.
inline std::vector<Solid> randomScene(base::Random& random) {
    std::vector<Solid> out;
    out.push_back({Solid::Kind::Box, {10, 0, 0}, {0.5, 20, 20}, random.uniform(-0.5, 0.5), 0});
    out.push_back({Solid::Kind::Box, {0, 0, -2}, {30, 30, random.uniform(0.4, 0.8)}, 0, 0});
    const auto somewhere = [&] {
        const double r = random.uniform(3, 8), a = random.uniform(-0.28, 0.28);
        return Vec3d{r * std::cos(a), r * std::sin(a), r * random.uniform(-0.15, 0.2)};
    };
    for (int k = 0; k < 2; ++k)
        out.push_back({Solid::Kind::Ball, somewhere(), {random.uniform(0.15, 0.5), 1, 1}, 0, 0});
    for (int k = 0; k < 2; ++k)
        out.push_back({Solid::Kind::Box,
                       somewhere(),
                       {random.uniform(0.1, 0.6), random.uniform(0.1, 0.6), random.uniform(0.1, 0.6)},
                       random.uniform(0, 3),
                       random.uniform(-0.4, 0.4)});
    for (int k = 0; k < 2; ++k)
        out.push_back({Solid::Kind::Cylinder,
                       somewhere(),
                       {random.uniform(0.05, 0.3), 1, random.uniform(0.2, 1)},
                       random.uniform(0, 3),
                       random.uniform(-1, 1)});
    out.push_back(
        {Solid::Kind::Cylinder, somewhere(), {random.uniform(0.015, 0.04), 1, 2}, 0, random.uniform(-1.2, 1.2)});
    return out;
}

} // namespace scan
