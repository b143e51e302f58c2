#include "core/mesh/finish/trim_folds.h"

#include "core/mesh/check/self_intersections.h"
#include "core/mesh/check/shape.h"
#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/finish/drop_triangles.h"

#include <algorithm>
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

/// Pairs of triangles near those vertices that cut each other; those without area with themselves.
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

/// One round of leaving out.
class Trim {
  public:
    explicit Trim(Mesh& mesh)
        : m_mesh(mesh), m_triangulation(mesh), m_gone(mesh.triangles.size()), m_touched(mesh.positions.size()) {}

    /// One of two that cut each other, the one that faces less as its normals do.
    void consider(std::uint32_t a, std::uint32_t b) {
        if (facing(b) < facing(a))
            std::swap(a, b);
        if (m_gone[a] || m_gone[b] || leaveOut(a))
            return;
        leaveOut(b);
    }

    std::size_t finish() {
        keepTriangles(m_mesh, [&](std::size_t t) { return !m_gone[t]; });
        return m_count;
    }

  private:
    /// Least cosine between a triangle's own normal and those at its corners.
    double facing(std::uint32_t t) const {
        const Triangle& corners = m_mesh.triangles[t];
        const Vec3d& first = m_mesh.positions[corners[0]];
        const Vec3d own =
            base::normalized(cross(m_mesh.positions[corners[1]] - first, m_mesh.positions[corners[2]] - first));
        double out = 1;
        for (const std::uint32_t v : corners)
            out = std::min(out, dot(own, base::cast<double>(m_mesh.normals[v])));
        return out;
    }

    /// Where that pinches nothing: with one side on the boundary, if the corner opposite is not on it; with two.
    bool leaveOut(std::uint32_t t) {
        const Triangle& corners = m_mesh.triangles[t];
        if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return m_touched[v]; }))
            return false;
        int sides = 0;
        Side open;
        for (int k = 0; k < 3; ++k)
            if (m_triangulation.onBoundary(Side{t, k}))
                ++sides, open = {t, k};
        if (sides == 0 || (sides == 1 && m_triangulation.onBoundary(m_triangulation.apex(open))))
            return false;
        const bool fold = std::any_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t v) { return m_mesh.kinds[v] == VertexKind::Fold; });
        for (const std::uint32_t v : corners) {
            m_touched[v] = true;
            if (m_mesh.kinds[v] == VertexKind::Inner)
                m_mesh.kinds[v] = fold ? VertexKind::Fold : VertexKind::Limit;
        }
        m_gone[t] = true;
        ++m_count;
        return true;
    }

    Mesh& m_mesh;
    Triangulation m_triangulation;
    std::vector<bool> m_gone, m_touched;
    std::size_t m_count = 0;
};

} // namespace

std::size_t reopenCut(Mesh& mesh, std::span<const std::uint32_t> middles, double cell) {
    if (middles.empty())
        return 0;
    std::vector<bool> isMiddle(mesh.positions.size()), reopened(mesh.positions.size());
    for (const std::uint32_t v : middles)
        isMiddle[v] = true;
    for (const auto& [a, b] : cutsNear(mesh, middles, cell))
        for (const std::uint32_t t : {a, b})
            for (const std::uint32_t v : mesh.triangles[t])
                reopened[v] = reopened[v] || isMiddle[v];
    std::vector<bool> gone(mesh.triangles.size());
    for (std::size_t t = 0; t < gone.size(); ++t) {
        const Triangle& corners = mesh.triangles[t];
        gone[t] = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return reopened[v]; });
        if (gone[t])
            for (const std::uint32_t v : corners)
                mesh.kinds[v] = VertexKind::Fold;
    }
    keepTriangles(mesh, [&](std::size_t t) { return !gone[t]; });
    const auto count = static_cast<std::size_t>(std::count(reopened.begin(), reopened.end(), true));
    if (count > 0)
        dropUnused(mesh);
    return count;
}

std::size_t trimFolds(Mesh& mesh, double cell) {
    constexpr int rounds = 6;
    std::vector<std::uint32_t> around;
    for (std::uint32_t v = 0; v < mesh.kinds.size(); ++v)
        if (mesh.kinds[v] != VertexKind::Inner)
            around.push_back(v);
    std::size_t count = 0;
    for (int round = 0; round < rounds; ++round) {
        const auto cuts = cutsNear(mesh, around, cell);
        around.clear();
        for (const auto& [a, b] : cuts)
            for (const std::uint32_t t : {a, b})
                around.insert(around.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
        if (cuts.empty())
            break;
        Trim trim(mesh);
        for (const auto& [a, b] : cuts)
            trim.consider(a, b);
        const std::size_t some = trim.finish();
        if (some == 0)
            break;
        count += some;
    }
    if (count > 0)
        dropUnused(mesh);
    return count;
}

} // namespace mesh
