// Models for meshers whose topology is known.
#pragma once

#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "surface/bounded.h"
#include "surface/shapes.h"

namespace models {

using base::Vec3d;

inline surface::Surface sampled(const char* id, std::size_t count) {
    return process::prepare(process::sample(id).make(count, 1), {});
}

inline surface::Surface halfSphere(std::size_t count) {
    const surfel::SurfelList all = shapes::sphere(count, 1, 3.5 * shapes::sphereSpacing(count, 1));
    surfel::SurfelList half;
    half.layout = all.layout;
    for (const surfel::Surfel& s : all.items)
        if (s.position.z > 0)
            half.items.push_back(s);
    return shapes::surfaceOf(half, shapes::bounded(0.3f));
}

/// The cube from -1 to 1, `side` points along an edge; edges are as round as the supports make them.
inline surface::Surface cube(int side) {
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    const double step = 2.0 / side;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            for (int i = 0; i < side; ++i)
                for (int j = 0; j < side; ++j) {
                    Vec3d p, n;
                    p[axis] = n[axis] = sign;
                    p[(axis + 1) % 3] = -1 + step * (i + 0.5);
                    p[(axis + 2) % 3] = -1 + step * (j + 0.5);
                    out.items.push_back(shapes::surfelAt(p, n, 2.5 * step));
                }
    return shapes::surfaceOf(out);
}

/// Two tori whose tubes run into each other: an eight.
inline surface::Surface doubleTorus(double spacing) {
    const double major = 1, minor = 0.45, apart = 1.1;
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    for (const double side : {-1.0, 1.0}) {
        const surfel::SurfelList one = shapes::torus(major, minor, spacing, 2.5 * spacing);
        for (surfel::Surfel s : one.items) {
            s.position.x += static_cast<float>(side * apart);
            const Vec3d p = base::cast<double>(s.position) + Vec3d{side * apart, 0, 0}; // seen from the other
            if (std::hypot(std::hypot(p.x, p.y) - major, p.z) > minor)
                out.items.push_back(s);
        }
    }
    return shapes::surfaceOf(out);
}

/// The same with the seam between them rounded off, as wide as the supports at least: a smooth surface of genus 2. The
/// distances to both are blended where they differ by less than `round`.
inline surface::Surface smoothDoubleTorus(double spacing) {
    const double major = 1, minor = 0.45, apart = 1.1, round = 0.5;
    const auto heightOver = [&](const Vec3d& p) {
        const auto to = [&](double side) {
            return std::hypot(std::hypot(p.x - side * apart, p.y) - major, p.z) - minor;
        };
        const double a = to(-1), b = to(1), near = std::max(0.0, 1 - std::abs(a - b) / round);
        return std::min(a, b) - 0.25 * round * near * near;
    };
    const auto slopeOf = [&](const Vec3d& p) {
        constexpr double step = 1e-5;
        Vec3d out;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Vec3d by;
            by[axis] = step;
            out[axis] = (heightOver(p + by) - heightOver(p - by)) / (2 * step);
        }
        return out;
    };
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    for (const double side : {-1.0, 1.0})
        for (const surfel::Surfel& s : shapes::torus(major, minor, spacing, 2.5 * spacing).items) {
            Vec3d p = base::cast<double>(s.position) + Vec3d{side * apart, 0, 0};
            if (p.x * side < 0) // the other one's half
                continue;
            for (int i = 0; i < 8; ++i)
                p -= slopeOf(p) * (heightOver(p) / lengthSq(slopeOf(p)));
            out.items.push_back(shapes::surfelAt(p, base::normalized(slopeOf(p)), 2.5 * spacing));
        }
    return shapes::surfaceOf(out);
}

/// Unit spheres about -x and x that touch in the origin.
inline surface::Surface touchingSpheres(std::size_t count, const surface::SurfaceDefinition& definition = {}) {
    surfel::SurfelList out = shapes::sphere(count, 1, 3 * shapes::sphereSpacing(count, 1));
    const std::size_t n = out.size();
    for (std::size_t i = 0; i < n; ++i) {
        surfel::Surfel s = out.items[i];
        out.items[i].position.x -= 1;
        s.position.x += 1;
        out.items.push_back(s);
    }
    return shapes::surfaceOf(out, definition);
}

} // namespace models
