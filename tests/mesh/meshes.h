// Meshes whose every number is known.
#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <map>

namespace meshes {

using base::Vec3d, mesh::Mesh, mesh::Triangle;

constexpr double pi = 3.14159265358979323846;

inline Mesh tetrahedron(const Vec3d& at = {}) {
    Mesh out;
    out.positions = {at, at + Vec3d{1, 0, 0}, at + Vec3d{0, 1, 0}, at + Vec3d{0, 0, 1}};
    out.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return out;
}

/// Both meshes beside each other.
inline Mesh together(Mesh a, const Mesh& b) {
    const auto before = static_cast<std::uint32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
    return a;
}

/// Vertex `from` becomes `to`.
inline Mesh joined(Mesh m, std::uint32_t from, std::uint32_t to) {
    for (Triangle& t : m.triangles)
        for (std::uint32_t& v : t)
            v = v == from ? to : v;
    return m;
}

/// A torus about the z axis of rows x columns squares, each cut in two; outward.
inline Mesh torus(std::uint32_t rows, std::uint32_t columns, double major = 1, double minor = 0.4) {
    Mesh out;
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const double u = 2 * pi * j / columns, v = 2 * pi * i / rows, ring = major + minor * std::cos(v);
            out.positions.push_back({ring * std::cos(u), ring * std::sin(u), minor * std::sin(v)});
        }
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) {
            const auto at = [&](std::uint32_t di, std::uint32_t dj) {
                return (i + di) % rows * columns + (j + dj) % columns;
            };
            out.triangles.push_back({at(0, 0), at(0, 1), at(1, 1)});
            out.triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
        }
    return out;
}

/// A band of half a twist, `columns` squares around and one across.
inline Mesh moebius(std::uint32_t columns) {
    Mesh out;
    for (std::uint32_t j = 0; j < columns; ++j)
        for (const double w : {-0.3, 0.3}) {
            const double u = 2 * pi * j / columns, r = 1 + w * std::cos(u / 2);
            out.positions.push_back({r * std::cos(u), r * std::sin(u), w * std::sin(u / 2)});
        }
    for (std::uint32_t j = 0; j < columns; ++j) {
        const bool last = j + 1 == columns;
        const std::uint32_t a = 2 * j, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        out.triangles.push_back({a, c, b});
        out.triangles.push_back({b, c, d});
    }
    return out;
}

/// Subdivided octahedron on the unit sphere; outward.
inline Mesh sphere(int levels) {
    Mesh out;
    out.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    out.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), out.positions.size());
            if (fresh)
                out.positions.push_back(base::normalized(out.positions[a] + out.positions[b]));
            return at->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : out.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(t);
        }
        out.triangles = finer;
    }
    return out;
}

} // namespace meshes
