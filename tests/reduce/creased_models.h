// Solids of planes, cylinders, balls and cones for the tests of reduced sets with cells: Booleans, sampled evenly or
// not, with labels from where faces really meet, and what rays truly hit.
#pragma once

#include "core/base/random.h"
#include "core/cells/labels.h"
#include "core/surface/surface.h"

#include <algorithm>
#include <functional>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace creased {

using base::Vec3d;

/// A surface of its own, inside where f < 0; `at` takes the unit square to it, evenly by area.
struct Face {
    std::function<double(const Vec3d&)> f;
    std::function<Vec3d(const Vec3d&)> normal;
    std::function<Vec3d(double u, double v)> at;
    double area = 0;
};

inline Face plane(const Vec3d& direction, double d, double half = 2.2) {
    const Vec3d n = base::normalized(direction), u = base::perpendicular(n), v = cross(n, u);
    return {[=](const Vec3d& x) { return dot(n, x) - d; }, [=](const Vec3d&) { return n; },
            [=](double a, double b) { return n * d + u * ((2 * a - 1) * half) + v * ((2 * b - 1) * half); },
            4 * half * half};
}
/// About an axis through `centre`; from outside, or as a hole.
inline Face cylinder(const Vec3d& centre, const Vec3d& direction, double radius, bool hole = false, double half = 2.2) {
    const Vec3d w = base::normalized(direction), u = base::perpendicular(w), v = cross(w, u);
    const double side = hole ? -1 : 1;
    const auto away = [=](const Vec3d& x) {
        const Vec3d q = x - centre;
        return q - w * dot(q, w);
    };
    return {[=](const Vec3d& x) { return side * (length(away(x)) - radius); },
            [=](const Vec3d& x) { return base::normalized(away(x)) * side; },
            [=](double a, double b) {
                const double angle = 2 * std::numbers::pi * a;
                return centre + (u * std::cos(angle) + v * std::sin(angle)) * radius + w * ((2 * b - 1) * half);
            },
            2 * std::numbers::pi * radius * 2 * half};
}
inline Face ball(const Vec3d& centre, double radius, bool hole = false) {
    const double side = hole ? -1 : 1;
    return {[=](const Vec3d& x) { return side * (length(x - centre) - radius); },
            [=](const Vec3d& x) { return base::normalized(x - centre) * side; },
            [=](double a, double b) {
                const double z = 2 * b - 1, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * std::numbers::pi * a;
                return centre + Vec3d{r * std::cos(angle), r * std::sin(angle), z} * radius;
            },
            4 * std::numbers::pi * radius * radius};
}

struct Model {
    std::vector<Face> faces;
    std::function<double(const std::vector<double>&)> combine;
    /// Is there surface at this place of the solid's boundary? Open models have parts of it.
    std::function<bool(const Vec3d&)> there = [](const Vec3d&) { return true; };
    double radius = 1.8; ///< of a ball that holds it

    double value(const Vec3d& x) const {
        thread_local std::vector<double> f;
        f.clear();
        for (const Face& face : faces)
            f.push_back(face.f(x));
        return combine(f);
    }
    /// Is x, on face i, on the boundary?
    bool onFace(std::size_t i, const Vec3d& x, double step) const {
        const Vec3d n = faces[i].normal(x);
        return value(x + n * step) > 0 && value(x - n * step) < 0 &&
               std::abs(value(x + n * step) - step) < 0.05 * step && there(x);
    }
    /// The nearest place to x where faces i and j meet, by Newton's steps from it.
    std::optional<Vec3d> meet(std::size_t i, std::size_t j, const Vec3d& from) const {
        Vec3d x = from;
        for (int k = 0; k < 30; ++k) {
            const Vec3d a = faces[i].normal(x), b = faces[j].normal(x);
            const double c = dot(a, b), det = 1 - c * c;
            if (det < 1e-5)
                return std::nullopt;
            const double f = faces[i].f(x) + dot(a, from - x), g = faces[j].f(x) + dot(b, from - x);
            const Vec3d next = from - a * ((f - c * g) / det) - b * ((g - c * f) / det);
            const double step = base::distance(next, x);
            x = next;
            if (step < 1e-12 * radius)
                break;
        }
        if (std::max(std::abs(faces[i].f(x)), std::abs(faces[j].f(x))) > 1e-9 * radius)
            return std::nullopt;
        return x;
    }
    /// Does face i end at x, where it meets j, and j there? Then how both meet.
    cells::Meeting meetingAt(std::size_t i, std::size_t j, const Vec3d& x, double step) const {
        const Vec3d a = faces[i].normal(x), b = faces[j].normal(x), way = base::normalized(cross(a, b));
        const auto begins = [&](std::size_t on, const Vec3d& n) {
            const Vec3d side = cross(way, n) * step;
            const auto down = [&](const Vec3d& y) { return y - faces[on].normal(y) * faces[on].f(y); };
            const bool left = onFace(on, down(x + side), 1e-3 * step), right = onFace(on, down(x - side), 1e-3 * step);
            return left == right ? 0 : left ? 1 : -1;
        };
        const int onI = begins(i, a), onJ = begins(j, b);
        if (onI == 0 || onJ == 0)
            return cells::Meeting::None;
        // the side on which face i goes on is behind j at an edge that stands out
        return dot(cross(way, a) * onI, b) < 0 ? cells::Meeting::Convex : cells::Meeting::Concave;
    }
    /// Where a ray first meets the solid; negative where it does not. `face`: which is hit.
    double hit(const base::Rayd& ray, double far, double step, std::size_t& face) const {
        double before = value(ray.origin), t = 0, from = 0;
        while (t < far) {
            from = t;
            t += std::max(step, 0.99 * std::abs(before)); // values change no faster than by the way
            const double next = value(ray.at(t));
            if ((next > 0) != (before > 0)) {
                double a = from, b = t;
                for (int k = 0; k < 60; ++k) {
                    const double m = (a + b) / 2;
                    ((value(ray.at(m)) > 0) == (before > 0) ? a : b) = m;
                }
                double least = 1e30;
                for (std::size_t i = 0; i < faces.size(); ++i)
                    if (const double f = std::abs(faces[i].f(ray.at(b))); f < least)
                        least = f, face = i;
                if (there(ray.at(b)))
                    return b;
            }
            before = next;
        }
        return -1;
    }
};

inline Model both(std::vector<Face> faces) {
    return {std::move(faces), [](const auto& f) { return *std::max_element(f.begin(), f.end()); }};
}

using Spacing = std::function<double(const Vec3d&)>;

/// Darts, with the wanted spacing at each place; places of faces move along their normals by `noise` spacings.
inline surfel::SurfelList sampled(const Model& model, const Spacing& spacing, double least, base::Random& random,
                                  double noise = 0) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    std::vector<cells::Label> labels;
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        const Face& face = model.faces[i];
        // grids by octaves of the spacing
        std::unordered_map<std::uint64_t, std::vector<std::pair<Vec3d, double>>> grid;
        std::vector<int> octaves;
        const auto key = [](int octave, const Vec3d& p, int a, int b, int c) {
            const double side = std::ldexp(1.0, octave);
            const auto at = [&](double x, int d) {
                return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / side)) + d) & 0xfffff;
            };
            return base::mix(static_cast<std::uint64_t>(octave + 64) ^
                             base::mix(at(p.x, a) << 40 | at(p.y, b) << 20 | at(p.z, c)));
        };
        const auto tries = static_cast<std::size_t>(10 * face.area / (least * least));
        for (std::size_t k = 0; k < tries; ++k) {
            const Vec3d p = face.at(random.uniform(), random.uniform());
            if (std::abs(model.value(p)) > 1e-9 * model.radius || !model.onFace(i, p, 1e-6 * model.radius))
                continue;
            const double s = spacing(p), apart = 0.8 * s;
            bool free = true;
            for (const int octave : octaves) {
                for (int a = -1; a <= 1 && free; ++a)
                    for (int b = -1; b <= 1 && free; ++b)
                        for (int c = -1; c <= 1 && free; ++c)
                            if (const auto at = grid.find(key(octave, p, a, b, c)); at != grid.end())
                                for (const auto& [q, other] : at->second)
                                    free = free && base::distance(p, q) >= std::min(apart, other);
            }
            if (!free)
                continue;
            const int octave = static_cast<int>(std::ceil(std::log2(apart)));
            if (std::find(octaves.begin(), octaves.end(), octave) == octaves.end())
                octaves.push_back(octave);
            grid[key(octave, p, 0, 0, 0)].push_back({p, apart});
            cells::Label label;
            label.cell = label.partner = label.face = static_cast<std::uint32_t>(i);
            double nearest = 2 * s;
            for (std::size_t j = 0; j < model.faces.size(); ++j) {
                if (j == i || std::abs(model.faces[j].f(p)) > 2 * s)
                    continue;
                const auto seam = model.meet(i, j, p);
                if (!seam || base::distance(*seam, p) >= nearest)
                    continue;
                if (const auto meeting = model.meetingAt(i, j, *seam, 1e-3 * s); meeting != cells::Meeting::None) {
                    nearest = base::distance(*seam, p);
                    label.partner = static_cast<std::uint32_t>(j);
                    label.meeting = meeting;
                }
            }
            surfel::Surfel surfel;
            surfel.position = base::cast<float>(p + face.normal(p) * (noise > 0 ? noise * s * random.normal() : 0));
            surfel.normal = base::cast<float>(face.normal(p));
            surfel.support = static_cast<float>(3.5 * s);
            out.append(surfel, {});
            labels.push_back(label);
        }
    }
    cells::setLabels(out, labels);
    return out;
}
inline surfel::SurfelList sampled(const Model& model, double spacing, base::Random& random, double noise = 0) {
    return sampled(
        model, [=](const Vec3d&) { return spacing; }, spacing, random, noise);
}

inline surface::Surface surfaceOf(const surfel::SurfelList& surfels) {
    surface::SurfaceDefinition definition;
    definition.boundary = surface::Boundary::None;
    definition.oneSheet = false;
    return {tree::SurfelTree::build(surfels), definition};
}

inline Model cappedCylinder() {
    return both({cylinder({}, {0, 0, 1}, 0.6), plane({0, 0, 1}, 0.7), plane({0, 0, -1}, 0.7)});
}
/// Two cylinders that cross, of different radii.
inline Model cross() {
    Model out = both({cylinder({}, {1, 0, 0}, 0.5), cylinder({}, {0, 1, 0.2}, 0.4), plane({1, 0, 0}, 1.1),
                      plane({-1, 0, 0}, 1.1), plane({0, 1, 0.2}, 1.1), plane({0, -1, -0.2}, 1.1)});
    out.combine = [](const auto& f) { return std::min(std::max({f[0], f[2], f[3]}), std::max({f[1], f[4], f[5]})); };
    return out;
}
inline Model lens(double apart = 0.7) {
    return both({ball({0, 0, apart}, 1), ball({0, 0, -apart}, 1)});
}
/// A wedge of that angle with its edge along y.
inline Model wedge(double degrees) {
    const double half = degrees * std::numbers::pi / 360;
    return both({plane({std::sin(half), 0, std::cos(half)}, 0.8 * std::sin(half)),
                 plane({std::sin(half), 0, -std::cos(half)}, 0.8 * std::sin(half)), plane({-1, 0, 0}, 0.8),
                 plane({0, 1, 0}, 0.8), plane({0, -1, 0}, 0.8)});
}
inline Model box(double x, double y, double z) {
    return both({plane({1, 0, 0}, x), plane({-1, 0, 0}, x), plane({0, 1, 0}, y), plane({0, -1, 0}, y),
                 plane({0, 0, 1}, z), plane({0, 0, -1}, z)});
}
/// A box with a ball half sunk into its top and a round hole through it.
inline Model boxWithBallAndHole() {
    Model out = box(1, 0.7, 0.4);
    out.faces.push_back(ball({-0.4, 0, 0.4}, 0.4));
    out.faces.push_back(cylinder({0.5, 0, 0}, {0, 0, 1}, 0.3, true));
    out.combine = [](const auto& f) {
        const double box = std::max({f[0], f[1], f[2], f[3], f[4], f[5]});
        return std::max(std::min(box, f[6]), f[7]);
    };
    return out;
}
/// A block with small bosses on its top, which are a few spacings wide.
inline Model bosses(double size, int count) {
    Model out = box(1, 0.7, 0.4);
    for (int k = 0; k < count; ++k) {
        // no two faces in one plane: every face is sampled wherever the solid has it
        const double x = -0.8 + 1.6 * k / std::max(1, count - 1), y = 0.3 * (k % 3 - 1) + 0.011 * k;
        const double half = size * (1 + 0.031 * k);
        for (const auto& [n, at] :
             {std::pair{Vec3d{1, 0, 0}, x}, {Vec3d{-1, 0, 0}, -x}, {Vec3d{0, 1, 0}, y}, {Vec3d{0, -1, 0}, -y}})
            out.faces.push_back(plane(n, at + half));
        out.faces.push_back(plane({0, 0, 1}, 0.4 + half));
    }
    out.combine = [](const auto& f) {
        double all = std::max({f[0], f[1], f[2], f[3], f[4], f[5]});
        for (std::size_t k = 6; k + 4 < f.size(); k += 5)
            all = std::min(all, std::max({f[k], f[k + 1], f[k + 2], f[k + 3], f[k + 4], -0.1 - f[4]}));
        return all;
    };
    return out;
}
inline Model gear(int teeth) {
    Model out = both({plane({0, 0, 1}, 0.25), plane({0, 0, -1}, 0.25), cylinder({}, {0, 0, 1}, 0.85),
                      cylinder({}, {0, 0, 1}, 0.3, true)});
    const double half = 0.5 * 0.85 * std::numbers::pi / teeth;
    for (int k = 0; k < teeth; ++k) {
        const double a = 2 * std::numbers::pi * k / teeth;
        const Vec3d r{std::cos(a), std::sin(a), 0}, side{-r.y, r.x, 0};
        out.faces.push_back(plane(side + r * 0.2, half + 0.2 * 0.85));
        out.faces.push_back(plane(-side + r * 0.2, half + 0.2 * 0.85));
        out.faces.push_back(plane(r, 1));
    }
    out.combine = [](const auto& f) {
        double wheel = f[2];
        for (std::size_t k = 4; k < f.size(); k += 3)
            wheel = std::min(wheel, std::max({f[k], f[k + 1], f[k + 2], -f[2] - 0.2, -f[k + 2] - 1}));
        return std::max({wheel, f[0], f[1], f[3]});
    };
    return out;
}
/// A box without the top and without a part of one side.
inline Model tray() {
    Model out = box(1, 0.7, 0.5);
    out.there = [](const Vec3d& x) { return x.z < 0.5 - 1e-6 && !(x.y > 0.7 - 1e-3 && x.z > 0.25 * x.x); };
    return out;
}

} // namespace creased
