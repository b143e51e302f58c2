#include "core/mesh/finish/trim_folds.h"

#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/finish/cuts_near.h"
#include "core/mesh/finish/drop_triangles.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

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
