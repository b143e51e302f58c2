// Solids made by code, sampled as scanners would: unions of balls, boxes, wedges and tori less holes of the same kinds,
// with points spread over the surface as far apart as asked for, exact normals, and known topology.
#pragma once

#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "surface/shapes.h"

#include <array>
#include <functional>
#include <unordered_map>

namespace solids {

using base::Vec3d;

/// A closed surface with its inside. `draw` makes a point on it, uniformly by area, and the normal there.
struct Part {
    double area = 0;
    std::function<double(const Vec3d&)> height; ///< above zero outside
    std::function<std::pair<Vec3d, Vec3d>(base::Random&)> draw;
};

inline Part ball(const Vec3d& centre, double radius) {
    return {4 * shapes::pi * radius * radius, [=](const Vec3d& x) { return distance(x, centre) - radius; },
            [=](base::Random& random) {
                const Vec3d n = random.unitVector();
                return std::pair(centre + n * radius, n);
            }};
}

/// Convex, of planar faces given by their corners, counter-clockwise from outside.
inline Part polytope(std::vector<std::vector<Vec3d>> faces) {
    struct Piece {
        Vec3d a, b, c, normal;
        double upTo;
    };
    std::vector<Piece> pieces;
    double area = 0;
    for (const auto& face : faces)
        for (std::size_t k = 2; k < face.size(); ++k) {
            const Vec3d n = cross(face[k - 1] - face[0], face[k] - face[0]);
            area += length(n) / 2;
            pieces.push_back({face[0], face[k - 1], face[k], base::normalized(n), area});
        }
    const auto height = [pieces](const Vec3d& x) {
        double out = -1e300;
        for (const Piece& p : pieces)
            out = std::max(out, dot(x - p.a, p.normal));
        return out;
    };
    const auto draw = [pieces, area](base::Random& random) {
        const double at = random.uniform(0, area);
        const auto p =
            std::find_if(pieces.begin(), pieces.end() - 1, [&](const Piece& each) { return each.upTo > at; });
        double u = random.uniform(), v = random.uniform();
        if (u + v > 1)
            u = 1 - u, v = 1 - v;
        return std::pair(p->a + (p->b - p->a) * u + (p->c - p->a) * v, p->normal);
    };
    return {area, height, draw};
}

/// A polygon in x and y, counter-clockwise, pulled from z = lo to z = hi.
inline Part prism(const std::vector<std::array<double, 2>>& polygon, double lo, double hi) {
    std::vector<std::vector<Vec3d>> faces(2);
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto &a = polygon[i], &b = polygon[(i + 1) % n];
        faces[1].push_back({a[0], a[1], hi});
        faces[0].insert(faces[0].begin(), Vec3d{a[0], a[1], lo});
        faces.push_back({{a[0], a[1], lo}, {b[0], b[1], lo}, {b[0], b[1], hi}, {a[0], a[1], hi}});
    }
    return polytope(faces);
}

inline Part box(const Vec3d& lo, const Vec3d& hi) {
    return prism({{lo.x, lo.y}, {hi.x, lo.y}, {hi.x, hi.y}, {lo.x, hi.y}}, lo.z, hi.z);
}

/// Of that angle at the z axis, its sides as long as `side`.
inline Part wedge(double angle, double side, double height) {
    return prism({{0, 0},
                  {side * std::cos(angle / 2), -side * std::sin(angle / 2)},
                  {side * std::cos(angle / 2), side * std::sin(angle / 2)}},
                 0, height);
}

inline Part torus(const Vec3d& centre, double major, double minor) {
    return {4 * shapes::pi * shapes::pi * major * minor,
            [=](const Vec3d& x) {
                const Vec3d d = x - centre;
                return std::hypot(std::hypot(d.x, d.y) - major, d.z) - minor;
            },
            [=](base::Random& random) {
                double v = 0;
                do
                    v = random.uniform(0, 2 * shapes::pi);
                while (random.uniform(0, major + minor) > major + minor * std::cos(v));
                const double u = random.uniform(0, 2 * shapes::pi), ring = major + minor * std::cos(v);
                const Vec3d n{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
                return std::pair(centre + Vec3d{ring * std::cos(u), ring * std::sin(u), minor * std::sin(v)}, n);
            }};
}

struct Solid {
    std::vector<Part> parts, holes;
    std::size_t pieces = 1; ///< of its surface
    long long genus = 0;    ///< of all of them

    /// Above zero outside; no distance.
    double height(const Vec3d& x) const {
        double out = 1e300;
        for (const Part& each : parts)
            out = std::min(out, each.height(x));
        for (const Part& each : holes)
            out = std::max(out, -each.height(x));
        return out;
    }
};

struct Sampling {
    double spacing = 0.1;
    /// Spacing grows by this factor along x, from one end of the unit interval to the other and beyond.
    double uneven = 1;
    double noise = 0; ///< of the positions, in spacings
    int outliers = 0;
    Vec3d offset;

    double at(const Vec3d& x) const { return spacing * std::pow(uneven, std::clamp(x.x, -0.5, 0.5)); }
};

/// Points that accept a new one only where none that faces alike is within 0.8 spacings: an even, random layout.
class Spread {
  public:
    explicit Spread(const Sampling& sampling) : m_sampling(sampling), m_cell(sampling.at({1, 0, 0})) {}

    bool take(const Vec3d& p, const Vec3d& n) {
        const double radius = 0.8 * m_sampling.at(p);
        for (long long z = -1; z <= 1; ++z)
            for (long long y = -1; y <= 1; ++y)
                for (long long x = -1; x <= 1; ++x)
                    for (const auto& [q, m] : m_cells[key(p + Vec3d{double(x), double(y), double(z)} * m_cell)])
                        if (distanceSq(p, q) < radius * radius && dot(n, m) > -0.5)
                            return false;
        m_cells[key(p)].push_back({p, n});
        return true;
    }

  private:
    std::uint64_t key(const Vec3d& p) const {
        const auto of = [&](double v) { return static_cast<std::uint64_t>(std::llround(v / m_cell) + (1 << 20)); };
        return of(p.x) | of(p.y) << 21 | of(p.z) << 42;
    }
    Sampling m_sampling;
    double m_cell;
    std::unordered_map<std::uint64_t, std::vector<std::pair<Vec3d, Vec3d>>> m_cells;
};

inline surfel::SurfelList sampled(const Solid& solid, const Sampling& sampling, base::Random& random) {
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    Spread spread(sampling);
    const auto add = [&](const Vec3d& p, const Vec3d& n) {
        const Vec3d noise{random.normal(), random.normal(), random.normal()};
        out.items.push_back(shapes::surfelAt(p + noise * (sampling.noise * sampling.at(p)) + sampling.offset, n, 0));
    };
    const double finest = std::min(sampling.at({-1, 0, 0}), sampling.at({1, 0, 0}));
    const auto cover = [&](const Part& part, double side, const auto& kept) {
        const auto draws = static_cast<std::size_t>(5 * part.area / (finest * finest));
        for (std::size_t i = 0; i < draws; ++i) {
            const auto [p, n] = part.draw(random);
            if (kept(p) && spread.take(p, n * side))
                add(p, n * side);
        }
    };
    const auto beyond = [](const std::vector<Part>& some, const Part* but, const Vec3d& p) {
        return std::all_of(some.begin(), some.end(),
                           [&](const Part& each) { return &each == but || each.height(p) > 0; });
    };
    for (const Part& part : solid.parts)
        cover(part, 1,
              [&](const Vec3d& p) { return beyond(solid.parts, &part, p) && beyond(solid.holes, nullptr, p); });
    for (const Part& hole : solid.holes)
        cover(hole, -1,
              [&](const Vec3d& p) { return beyond(solid.holes, &hole, p) && !beyond(solid.parts, nullptr, p); });
    for (int i = 0; i < sampling.outliers; ++i) {
        const Vec3d p = base::cast<double>(out.items[random.below(out.size())].position);
        const Vec3d n = random.unitVector();
        out.items.push_back(
            shapes::surfelAt(p + random.unitVector() * (sampling.spacing * random.uniform(4, 12)), n, 0));
    }
    return out;
}

/// Supports as for a file with these points; closed.
inline surface::Surface surfaceOf(surfel::SurfelList list, bool oneSheet = true) {
    surface::SurfaceDefinition closed;
    closed.boundary = surface::Boundary::None;
    closed.oneSheet = oneSheet;
    return process::prepare(std::move(list), {.definition = closed});
}

inline Solid comb(double thickness, double gap) {
    Solid out{{box({-0.5, -0.3, -0.3}, {0.5, 0.3, 0})}, {}, 1, 0};
    for (double x = -0.45; x + thickness < 0.45; x += thickness + gap)
        out.parts.push_back(box({x, -0.25, -0.1}, {x + thickness, 0.25, 0.4}));
    return out;
}

inline Solid shell(double thickness) {
    return {{ball({}, 0.5)}, {ball({}, 0.5 - thickness)}, 2, 0};
}

/// Both pierced by each other.
inline Solid crossedSlabs(double thickness) {
    return {{box({-0.5, -0.4, -thickness / 2}, {0.5, 0.4, thickness / 2}),
             box({-0.4, -thickness / 2, -0.5}, {0.4, thickness / 2, 0.5})},
            {},
            1,
            0};
}

/// A box with a round hole through it: a torus, for topologists.
inline Solid drilled(double radius) {
    return {{box({-0.4, -0.4, -0.3}, {0.4, 0.4, 0.3})}, {box({-radius, -radius, -1}, {radius, radius, 1})}, 1, 1};
}

inline Solid tori() {
    return {{torus({-0.35, 0, 0}, 0.3, 0.13), torus({0.35, 0, 0}, 0.3, 0.13)}, {}, 1, 2};
}

/// Balls in a row of random radii, each running into the next.
inline Solid balls(base::Random& random) {
    Solid out;
    double x = -0.4;
    for (int i = 0; i < 4; ++i) {
        const double radius = random.uniform(0.15, 0.3);
        out.parts.push_back(ball({x, random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)}, radius));
        x += 0.27;
    }
    return out;
}

} // namespace solids
