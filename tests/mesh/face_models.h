// Meshes of all kinds for the tests of faces that come in.
#pragma once

#include "core/base/random.h"
#include "core/mesh/faces/face_points.h"
#include "core/mesh/faces/face_topology.h"
#include "core/surfel/surfel.h"

#include <numbers>

namespace faces {

using base::Vec3d;
using base::Vec3f;
using mesh::FacePoint;
using mesh::FaceTopology;
using mesh::Triangle;

constexpr double sharp = 40 * std::numbers::pi / 180;

inline surfel::Surfel at(const Vec3f& position) {
    surfel::Surfel out;
    out.position = position;
    return out;
}

struct Faces {
    std::vector<Vec3f> positions;
    std::vector<Triangle> triangles;

    FaceTopology topology(double at = sharp) const { return mesh::faceTopology(positions, triangles, at); }
    surfel::SurfelList list() const {
        surfel::SurfelList out;
        for (const Vec3f& p : positions)
            out.append(at(p), {});
        return out;
    }
};

/// Corners of a box, two triangles a side, outwards.
inline Faces box(Vec3f size) {
    Faces out;
    for (int i = 0; i < 8; ++i)
        out.positions.push_back({static_cast<float>(i & 1) * size.x, static_cast<float>(i >> 1 & 1) * size.y,
                                 static_cast<float>(i >> 2) * size.z});
    constexpr std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        out.triangles.push_back({q[0], q[1], q[2]});
        out.triangles.push_back({q[0], q[2], q[3]});
    }
    return out;
}

/// A grid over a torus (1, 0.4), or a strip with half a turn of the same faces.
inline Faces band(std::uint32_t around, std::uint32_t across, bool moebius) {
    Faces out;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = moebius ? u / 2 : 2 * std::numbers::pi * k / across;
            const double r = moebius ? 0.4 * (2.0 * k / (across - 1) - 1) : 0.4;
            out.positions.push_back(base::cast<float>(
                Vec3d{(1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v)}));
        }
    const auto at = [&](std::uint32_t i, std::uint32_t k) {
        const bool over = i == around;
        return (over ? 0 : i) * across + (over && moebius ? across - 1 - k : k % across);
    };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t k = 0; k + (moebius ? 1 : 0) < across; ++k) {
            out.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            out.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return out;
}

/// Triangles of all shapes, slivers and points among them.
inline Faces soup(std::uint64_t seed, std::size_t count) {
    base::Random random(seed);
    Faces out;
    for (std::uint32_t t = 0; t < count; ++t) {
        const Vec3d middle = random.unitVector() * random.uniform(0, 2);
        const double size = std::pow(10, random.uniform(-3, 0));
        for (int k = 0; k < 3; ++k)
            out.positions.push_back(base::cast<float>(middle + random.unitVector() * (k == 2 ? size * size : size)));
        out.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return out;
}

inline double areaOf(const std::vector<Vec3f>& p, const std::vector<Triangle>& triangles) {
    double out = 0;
    for (const Triangle& t : triangles)
        out += length(cross(base::cast<double>(p[t[1]] - p[t[0]]), base::cast<double>(p[t[2]] - p[t[0]]))) / 2;
    return out;
}

inline std::vector<Vec3f> placesOf(const Faces& faces, const FaceTopology& topology, std::size_t count) {
    std::vector<Vec3f> out;
    for (const FacePoint& point : mesh::spreadPoints(topology, faces.positions, count))
        out.push_back(base::cast<float>(mesh::placeOf(point, topology, faces.positions)));
    return out;
}

} // namespace faces
