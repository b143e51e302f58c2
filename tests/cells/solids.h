// Solids of planes for the tests of cells: Booleans of half-spaces, sampled with labels, and what is true of them.
#pragma once

#include "core/base/random.h"
#include "core/cells/cell_surface.h"
#include "core/cells/crease_labels.h"

#include <array>
#include <functional>

namespace plane_solids {

using base::Vec3d;

constexpr double pi = 3.14159265358979323846;

/// Inside where n.x < d.
struct Plane {
    Vec3d n;
    double d = 0;
    double f(const Vec3d& x) const { return dot(n, x) - d; }
};

/// A Boolean of half-spaces with a value at each place: max of an intersection, min of a union.
struct Solid {
    std::vector<Plane> planes;
    std::function<double(const std::vector<double>& f)> combine;
    std::function<bool(std::size_t a, std::size_t b)> convex; ///< do planes a and b meet convexly?

    double value(const Vec3d& x) const {
        std::vector<double> f;
        for (const Plane& plane : planes)
            f.push_back(plane.f(x));
        return combine(f);
    }
    /// Is x, on plane i, on the boundary?
    bool onFace(std::size_t i, const Vec3d& x, double step) const {
        return value(x + planes[i].n * step) > 0 && value(x - planes[i].n * step) < 0 &&
               std::abs(value(x + planes[i].n * step) - step) < 1e-3 * step;
    }
    /// First entry or exit along a ray, by all planes; negative where there is none. `plane` is the one that is hit.
    double hit(const base::Rayd& ray, std::size_t& plane) const {
        double best = -1;
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const double slope = dot(planes[i].n, ray.direction);
            const double t = -planes[i].f(ray.origin) / slope;
            if (!(t > 0) || (best >= 0 && t >= best))
                continue;
            const double before = value(ray.at(t - 1e-9)), after = value(ray.at(t + 1e-9));
            if ((before > 0) != (after > 0)) {
                best = t;
                plane = i;
            }
        }
        return best;
    }
};

inline Solid intersection(std::vector<Plane> planes) {
    return {std::move(planes), [](const std::vector<double>& f) { return *std::max_element(f.begin(), f.end()); },
            [](std::size_t, std::size_t) { return true; }};
}
inline Solid unionOf(std::vector<Plane> planes) {
    return {std::move(planes), [](const std::vector<double>& f) { return *std::min_element(f.begin(), f.end()); },
            [](std::size_t, std::size_t) { return false; }};
}
/// Of three planes: the first cut with, or joined to, the Boolean of the other two of the other kind.
inline Solid mixedCorner(std::vector<Plane> planes, bool cut) {
    return {std::move(planes),
            [cut](const std::vector<double>& f) {
                return cut ? std::max(f[0], std::min(f[1], f[2])) : std::min(f[0], std::max(f[1], f[2]));
            },
            [cut](std::size_t a, std::size_t b) { return (a == 0 || b == 0) == cut; }};
}

/// Planes around the origin, a few directions each of random length: a polyhedron with all kinds of edges and corners.
inline Solid polyhedron(base::Random& random) {
    std::vector<Plane> planes;
    for (int i = 0; i < 7; ++i) {
        const double z = 1 - 2 * (i + 0.5) / 7, a = i * 2.4 + random.uniform(-0.2, 0.2), r = std::sqrt(1 - z * z);
        planes.push_back({{r * std::cos(a), r * std::sin(a), z}, random.uniform(0.7, 0.9)});
    }
    return intersection(std::move(planes));
}

struct SampledSolid {
    Solid solid;
    surfel::SurfelList surfels;
    double spacing = 0;
};

/// Jittered grids on the planes within `radius` of the origin, where they are the solid's boundary; labels from the
/// edges, which are found on the lines where two planes meet.
inline SampledSolid sampled(const Solid& solid, double radius, double spacing, base::Random& random,
                            double jitter = 0.25) {
    SampledSolid out{solid, {}, spacing};
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.surfels.layout = layout;
    std::vector<std::uint32_t> cells;
    std::vector<cells::CreasePiece> creases;
    for (std::size_t i = 0; i < solid.planes.size(); ++i) {
        const Plane& plane = solid.planes[i];
        const Vec3d u = base::perpendicular(plane.n), v = cross(plane.n, u), foot = plane.n * plane.d;
        const int half = static_cast<int>(radius / spacing) + 1;
        for (int a = -half; a <= half; ++a)
            for (int b = -half; b <= half; ++b) {
                const double x = (a + 0.5 + random.uniform(-jitter, jitter)) * spacing;
                const double y = (b + 0.5 + random.uniform(-jitter, jitter)) * spacing;
                const Vec3d p = foot + u * x + v * y;
                if (length(p) > radius || !solid.onFace(i, p, 1e-7 * radius))
                    continue;
                surfel::Surfel s;
                s.position = base::cast<float>(p);
                s.normal = base::cast<float>(plane.n);
                s.support = static_cast<float>(3.5 * spacing);
                out.surfels.append(s, {});
                cells.push_back(static_cast<std::uint32_t>(i));
            }
    }
    for (std::size_t i = 0; i < solid.planes.size(); ++i)
        for (std::size_t j = i + 1; j < solid.planes.size(); ++j) {
            const Plane &a = solid.planes[i], &b = solid.planes[j];
            const Vec3d along = cross(a.n, b.n);
            if (length(along) < 1e-6)
                continue;
            const Vec3d way = base::normalized(along);
            const double c = dot(a.n, b.n), det = 1 - c * c;
            const Vec3d foot = a.n * ((a.d - b.d * c) / det) + b.n * ((b.d - a.d * c) / det);
            const double step = spacing / 8;
            for (double t = -2 * radius; t < 2 * radius; t += step) {
                // both faces begin beside the piece
                const Vec3d mid = foot + way * (t + step / 2);
                const auto begins = [&](std::size_t on, std::size_t other) {
                    const Vec3d side = base::normalized(cross(way, solid.planes[on].n));
                    const double e = 0.01 * spacing;
                    const bool left = solid.onFace(on, mid + side * e, 1e-3 * e);
                    const bool right = solid.onFace(on, mid - side * e, 1e-3 * e);
                    (void)other;
                    return left != right;
                };
                if (begins(i, j) && begins(j, i))
                    creases.push_back({foot + way * t, foot + way * (t + step), static_cast<std::uint32_t>(i),
                                       static_cast<std::uint32_t>(j),
                                       solid.convex(i, j) ? cells::Meeting::Convex : cells::Meeting::Concave});
            }
        }
    cells::setLabels(out.surfels, cells::labelsByCreases(out.surfels.items, cells, creases, spacing));
    return out;
}

inline surface::Surface surfaceOf(const surfel::SurfelList& surfels) {
    surface::SurfaceDefinition definition;
    definition.boundary = surface::Boundary::None;
    definition.oneSheet = false;
    return {tree::SurfelTree::build(surfels), definition};
}
inline cells::CellSurface cellsOf(const surfel::SurfelList& surfels) {
    return *cells::CellSurface::of(surfaceOf(surfels));
}

inline Solid cube(double half) {
    return intersection({{{1, 0, 0}, half},
                         {{-1, 0, 0}, half},
                         {{0, 1, 0}, half},
                         {{0, -1, 0}, half},
                         {{0, 0, 1}, half},
                         {{0, 0, -1}, half}});
}

/// A box of 2 by 2 by 1 halves without the quadrant x, y > 0.
inline Solid lBlock(double half) {
    return {{{{1, 0, 0}, half},
             {{-1, 0, 0}, half},
             {{0, 1, 0}, half},
             {{0, -1, 0}, half},
             {{0, 0, 1}, half / 2},
             {{0, 0, -1}, half / 2},
             {{1, 0, 0}, 0},
             {{0, 1, 0}, 0}},
            [](const std::vector<double>& f) {
                const double box = std::max({f[0], f[1], f[2], f[3], f[4], f[5]});
                return std::max(box, std::min(f[6], f[7]));
            },
            [](std::size_t a, std::size_t b) { return !(std::min(a, b) == 6 && std::max(a, b) == 7); }};
}

/// A pyramid of `sides` flat faces about the z axis with its tip at `height`, on the plane z = 0.
inline Solid pyramid(int sides, double radius, double height) {
    std::vector<Plane> planes{{{0, 0, -1}, 0}};
    for (int i = 0; i < sides; ++i) {
        const double a = 2 * pi * i / sides;
        const Vec3d n = base::normalized(Vec3d{height * std::cos(a), height * std::sin(a), radius});
        planes.push_back({n, n.z * height});
    }
    return intersection(std::move(planes));
}

/// An eighth of the unit ball: three quarters of discs and a part of a sphere.
inline surfel::SurfelList octant(double spacing, base::Random& random) {
    surfel::SurfelList surfels;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    surfels.layout = layout;
    std::vector<std::uint32_t> cell;
    const auto add = [&](const Vec3d& p, const Vec3d& n, std::uint32_t c) {
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        s.normal = base::cast<float>(n);
        s.support = static_cast<float>(3.5 * spacing);
        surfels.append(s, {});
        cell.push_back(c);
    };
    const int half = static_cast<int>(1 / spacing) + 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int a = 0; a < half; ++a)
            for (int b = 0; b < half; ++b) {
                Vec3d p;
                p[(axis + 1) % 3] = (a + 0.5 + random.uniform(-0.25, 0.25)) * spacing;
                p[(axis + 2) % 3] = (b + 0.5 + random.uniform(-0.25, 0.25)) * spacing;
                Vec3d n;
                n[axis] = -1;
                if (length(p) < 1)
                    add(p, n, static_cast<std::uint32_t>(axis));
            }
    const auto count = static_cast<std::size_t>(4 * pi / (spacing * spacing));
    for (std::size_t i = 0; i < count; ++i) { // golden-angle spiral
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count), r = std::sqrt(1 - z * z);
        const double angle = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
        const Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
        if (n.x > 0 && n.y > 0 && n.z > 0)
            add(n, n, 3);
    }
    std::vector<cells::CreasePiece> pieces;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        Vec3d u, v;
        u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
        pieces.push_back({{}, u, axis, (axis + 2) % 3, cells::Meeting::Convex});
        for (int k = 0; k < 64; ++k) {
            const auto at = [&](int i) { return u * std::cos(i * pi / 128) + v * std::sin(i * pi / 128); };
            pieces.push_back({at(k), at(k + 1), axis, 3, cells::Meeting::Convex});
        }
    }
    cells::setLabels(surfels, cells::labelsByCreases(surfels.items, cell, pieces, spacing));
    return surfels;
}

/// A ray to `target` from `far` away.
inline base::Rayd towards(const Vec3d& target, const Vec3d& direction, double far) {
    return {target - direction * far, direction};
}

} // namespace plane_solids
