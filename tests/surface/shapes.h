// Sample layouts with exact normals and one support radius, made for the surface tests.
#pragma once

#include "core/base/random.h"
#include "core/surface/surface.h"
#include <cstring>

#include <functional>

namespace shapes {

constexpr double pi = 3.14159265358979323846;

inline surfel::AttributeLayoutPtr layout(bool normals, bool oriented) {
    auto out = std::make_shared<surfel::AttributeLayout>();
    out->normals = normals;
    out->oriented = oriented;
    return out;
}

inline surfel::Surfel surfelAt(const base::Vec3d& p, const base::Vec3d& n, double support) {
    surfel::Surfel s;
    s.position = base::cast<float>(p);
    s.normal = base::cast<float>(n);
    s.support = static_cast<float>(support);
    return s;
}

/// Points of a golden-angle spiral on a sphere about the origin.
inline surfel::SurfelList sphere(std::size_t count, double radius, double support) {
    surfel::SurfelList out;
    out.layout = layout(true, true);
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
        const double r = std::sqrt(1 - z * z), angle = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
        const base::Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
        out.items.push_back(surfelAt(n * radius, n, support));
    }
    return out;
}

/// Spacing of `count` samples of a sphere: sqrt(area / count).
inline double sphereSpacing(std::size_t count, double radius) {
    return radius * std::sqrt(4 * pi / static_cast<double>(count));
}

/// A torus about the z axis, rows of about equal spacing.
inline surfel::SurfelList torus(double major, double minor, double spacing, double support) {
    surfel::SurfelList out;
    out.layout = layout(true, true);
    const int rows = static_cast<int>(std::lround(2 * pi * minor / spacing));
    for (int i = 0; i < rows; ++i) {
        const double v = 2 * pi * i / rows, ring = major + minor * std::cos(v);
        const int columns = static_cast<int>(std::lround(2 * pi * ring / spacing));
        for (int j = 0; j < columns; ++j) {
            const double u = 2 * pi * (j + 0.5 * (i % 2)) / columns;
            const base::Vec3d n{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
            const base::Vec3d p{ring * std::cos(u), ring * std::sin(u), minor * std::sin(v)};
            out.items.push_back(surfelAt(p, n, support));
        }
    }
    return out;
}

/// A place up to `distance` from one of the surfels.
inline base::Vec3f beside(const surfel::SurfelList& list, base::Random& random, double distance) {
    const surfel::Surfel& s = list.items[random.below(list.items.size())];
    return s.position + base::cast<float>(random.unitVector() * (distance * random.uniform()));
}

/// A square grid of (2 half + 1)^2 points in the plane z = height with one normal.
inline surfel::SurfelList plane(int half, double spacing, double support, double height = 0, double normalZ = 1) {
    surfel::SurfelList out;
    out.layout = layout(true, true);
    for (int i = -half; i <= half; ++i)
        for (int j = -half; j <= half; ++j)
            out.items.push_back(surfelAt({i * spacing, j * spacing, height}, {0, 0, normalZ}, support));
    return out;
}

/// Two such squares that face away from each other, above and below z = 0: the upper one first.
inline surfel::SurfelList plates(int half, double spacing, double support, double thickness) {
    surfel::SurfelList out = plane(half, spacing, support, 0.5 * thickness, 1);
    const surfel::SurfelList below = plane(half, spacing, support, -0.5 * thickness, -1);
    out.items.insert(out.items.end(), below.items.begin(), below.items.end());
    return out;
}

/// Moves every point by up to `by` in each axis and turns its normal a little.
inline surfel::SurfelList jittered(surfel::SurfelList list, double by, std::uint64_t seed) {
    base::Random random(seed);
    for (surfel::Surfel& s : list.items) {
        const base::Vec3d offset{random.uniform(-by, by), random.uniform(-by, by), random.uniform(-by, by)};
        s.position = base::cast<float>(base::cast<double>(s.position) + offset);
        const base::Vec3d tilt = random.unitVector() * 0.2;
        s.normal = base::cast<float>(base::normalized(base::cast<double>(s.normal) + tilt));
    }
    return list;
}

inline surface::Surface surfaceOf(const surfel::SurfelList& list, const surface::SurfaceDefinition& definition = {}) {
    return {tree::SurfelTree::build(list), definition};
}

inline surface::SurfaceDefinition definitionOf(surface::Frame frame, bool shrinkFree = false,
                                               surface::Weight weight = surface::Weight::Wendland) {
    surface::SurfaceDefinition d;
    d.frame = frame;
    d.shrinkFree = shrinkFree;
    d.weight = weight;
    return d;
}

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

} // namespace shapes
