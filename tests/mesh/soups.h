// Faces as files bring them that were put together of parts: solids that share walls, run into each other, repeat faces
// and turn them, with what they enclose known.
#pragma once

#include "face_models.h"

#include <algorithm>
#include <array>

namespace soups {

using base::Vec3d;
using faces::Faces;
using mesh::Triangle;

/// A box along a frame of its own.
struct Box {
    Vec3d centre, half, axes[3];

    double height(const Vec3d& x) const { ///< above zero outside
        double out = -1e300;
        for (std::size_t k = 0; k < 3; ++k)
            out = std::max(out, std::abs(dot(x - centre, axes[k])) - half[k]);
        return out;
    }
    Faces faces() const {
        Faces out = faces::box({2, 2, 2});
        for (base::Vec3f& p : out.positions) {
            const Vec3d at = base::cast<double>(p) - Vec3d{1, 1, 1};
            p = base::cast<float>(centre + axes[0] * (at.x * half.x) + axes[1] * (at.y * half.y) +
                                  axes[2] * (at.z * half.z));
        }
        return out;
    }
};

inline Box aligned(const Vec3d& lo, const Vec3d& hi) {
    return {(lo + hi) / 2, (hi - lo) / 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

inline Box tilted(base::Random& random, double extent, double least, double most) {
    Box out;
    out.centre = Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)} * extent;
    for (std::size_t k = 0; k < 3; ++k)
        out.half[k] = random.uniform(least, most);
    out.axes[0] = random.unitVector();
    out.axes[1] = base::perpendicular(out.axes[0]);
    out.axes[2] = cross(out.axes[0], out.axes[1]);
    return out;
}

inline void append(Faces& to, const Faces& more) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), more.positions.begin(), more.positions.end());
    for (const Triangle& t : more.triangles)
        to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Every face with corners of its own, in an order by chance, as STL files have them.
inline Faces shuffled(const Faces& faces, base::Random& random) {
    std::vector<Triangle> triangles = faces.triangles;
    for (std::size_t i = triangles.size(); i > 1; --i)
        std::swap(triangles[i - 1], triangles[random.below(i)]);
    Faces out;
    for (const Triangle& t : triangles) {
        const auto first = static_cast<std::uint32_t>(out.positions.size());
        const auto turn = random.below(3);
        for (std::uint32_t k = 0; k < 3; ++k)
            out.positions.push_back(faces.positions[t[(k + turn) % 3]]);
        out.triangles.push_back({first, first + 1, first + 2});
    }
    return out;
}

/// Turns some of the faces round.
inline void turnSome(Faces& faces, base::Random& random, double share) {
    for (Triangle& t : faces.triangles)
        if (random.uniform() < share)
            std::swap(t[1], t[2]);
}

/// Cubes of a grid of 3 x 3 x 3, those of `filled`, each with all of its faces: what two share is there twice.
struct Bricks {
    std::array<bool, 27> filled{};

    bool has(int x, int y, int z) const {
        return std::min({x, y, z}) >= 0 && std::max({x, y, z}) < 3 &&
               filled[static_cast<std::size_t>(9 * x + 3 * y + z)];
    }
    template <class Fn>
    void forEach(const Fn& fn) const {
        for (int i = 0; i < 27; ++i)
            if (filled[static_cast<std::size_t>(i)])
                fn(i / 9, i / 3 % 3, i % 3);
    }
    /// Of the outer faces.
    double area() const {
        double out = 0;
        forEach([&](int x, int y, int z) {
            out += !has(x - 1, y, z) + !has(x + 1, y, z) + !has(x, y - 1, z) + !has(x, y + 1, z) + !has(x, y, z - 1) +
                   !has(x, y, z + 1);
        });
        return out;
    }
    double volume() const { return static_cast<double>(std::count(filled.begin(), filled.end(), true)); }
};

/// Grown from a cube by neighbours. One neighbour of the middle stays free, so that nothing is closed in.
inline Bricks bricks(base::Random& random, std::size_t count) {
    constexpr int corner = 0, kept = 22; // {2, 1, 1}
    Bricks out;
    out.filled[corner] = true;
    while (static_cast<std::size_t>(out.volume()) < count) {
        const int i = static_cast<int>(random.below(27)), x = i / 9, y = i / 3 % 3, z = i % 3;
        if (i != kept && (out.has(x - 1, y, z) || out.has(x + 1, y, z) || out.has(x, y - 1, z) ||
                          out.has(x, y + 1, z) || out.has(x, y, z - 1) || out.has(x, y, z + 1)))
            out.filled[static_cast<std::size_t>(i)] = true;
    }
    return out;
}

/// Their faces. `walls`: how often what two share is there, one or two times.
inline Faces facesOf(const Bricks& all, int walls) {
    Faces out;
    all.forEach([&](int x, int y, int z) {
        Faces one = faces::box({1, 1, 1});
        for (base::Vec3f& p : one.positions)
            p += base::cast<float>(Vec3d{double(x), double(y), double(z)});
        if (walls == 1) { // the neighbour with the lower numbers has it
            std::vector<Triangle> kept;
            const bool shared[3] = {all.has(x - 1, y, z), all.has(x, y - 1, z), all.has(x, y, z - 1)};
            for (const Triangle& t : one.triangles) {
                bool left = false;
                for (std::size_t k = 0; k < 3; ++k)
                    left |= shared[k] &&
                            std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return (v >> k & 1u) == 0; });
                if (!left)
                    kept.push_back(t);
            }
            one.triangles = kept;
        }
        append(out, one);
    });
    return out;
}

/// Cuts triangles at random places of random sides, those beside alike, so that no corner lies on a side: the
/// faces of a fan of needles are 1000 times as large as others.
inline void halveSome(Faces& faces, base::Random& random, int times) {
    for (; times > 0; --times) {
        const Triangle picked = faces.triangles[random.below(faces.triangles.size())];
        const std::size_t k = random.below(3);
        const base::Vec3f a = faces.positions[picked[k]], b = faces.positions[picked[(k + 1) % 3]];
        const auto t = static_cast<float>(random.uniform(0.02, 0.98));
        const auto middle = static_cast<std::uint32_t>(faces.positions.size());
        faces.positions.push_back(a + (b - a) * t);
        for (std::size_t i = 0, count = faces.triangles.size(); i < count; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const Triangle f = faces.triangles[i];
                const base::Vec3f &p = faces.positions[f[j]], &q = faces.positions[f[(j + 1) % 3]];
                if (!((p == a && q == b) || (p == b && q == a)))
                    continue;
                faces.triangles[i] = {f[j], middle, f[(j + 2) % 3]};
                faces.triangles.push_back({middle, f[(j + 1) % 3], f[(j + 2) % 3]});
                break;
            }
    }
}

inline Faces together(const std::vector<Box>& boxes) {
    Faces out;
    for (const Box& b : boxes)
        append(out, b.faces());
    return out;
}

} // namespace soups
