#include "core/mesh/finish/cuts_near.h"

#include "core/mesh/check/self_intersections.h"
#include "core/mesh/check/shape.h"

#include <unordered_set>

namespace mesh {

using base::Vec3d;

namespace {

/// What is near some vertices, by cubes of space.
class Region {
  public:
    Region(const Mesh& mesh, std::span<const std::uint32_t> around, double size) : m_mesh(mesh), m_size(size) {
        for (const std::uint32_t v : around) {
            const Cube c = cubeOf(mesh.positions[v]);
            for (long long i = -1; i <= 1; ++i)
                for (long long j = -1; j <= 1; ++j)
                    for (long long k = -1; k <= 1; ++k)
                        m_cubes.insert(key({c.x + i, c.y + j, c.z + k}));
        }
    }

    std::vector<std::uint32_t> triangles() const {
        std::vector<std::uint32_t> out;
        for (std::uint32_t t = 0; t < m_mesh.triangles.size(); ++t)
            if (m_cubes.contains(key(cubeOf(m_mesh.positions[m_mesh.triangles[t][0]]))))
                out.push_back(t);
        return out;
    }

  private:
    struct Cube {
        long long x = 0, y = 0, z = 0;
    };
    Cube cubeOf(const Vec3d& p) const {
        return {std::llround(p.x / m_size), std::llround(p.y / m_size), std::llround(p.z / m_size)};
    }
    /// Two cubes may have the same: then more is looked at than need be.
    static std::uint64_t key(const Cube& c) {
        return static_cast<std::uint64_t>(c.x) * 0x9e3779b97f4a7c15ull ^
               static_cast<std::uint64_t>(c.y) * 0xc2b2ae3d27d4eb4full ^
               static_cast<std::uint64_t>(c.z) * 0x165667b19e3779f9ull;
    }

    const Mesh& m_mesh;
    double m_size;
    std::unordered_set<std::uint64_t> m_cubes;
};

bool isFlat(const Mesh& mesh, std::uint32_t t) {
    const auto at = [&](std::size_t corner) { return mesh.positions[mesh.triangles[t][corner]]; };
    return smallestAngle(at(0), at(1), at(2)) == 0;
}

} // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> cutsNear(const Mesh& mesh, std::span<const std::uint32_t> around,
                                                              double cell) {
    constexpr double reach = 2; // cells
    if (around.empty())
        return {};
    const std::vector<std::uint32_t> near = Region(mesh, around, reach * cell).triangles();
    auto out = selfIntersections(mesh, near);
    for (const std::uint32_t t : near)
        if (isFlat(mesh, t))
            out.emplace_back(t, t);
    return out;
}

} // namespace mesh
