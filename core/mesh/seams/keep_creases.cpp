#include "core/mesh/seams/keep_creases.h"

#include "core/mesh/check/shape.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/seams/crease_tidy.h"
#include "core/process/estimation/part_progress.h"

namespace mesh {

namespace {

constexpr int rounds = 5; ///< of cuts, with more left as it was in each

/// Vertices that stay where the smooth surface has them.
class HeldVertices {
  public:
    HeldVertices(const Mesh& mesh, std::span<const CreaseVertex> onFaces)
        : m_triangles(mesh.triangles), m_onFaces(onFaces), m_held(mesh.positions.size()) {}

    /// Those that the corners of these triangles come from, and `rings` rings about them. False where no more of them
    /// are near creases: the smooth mesh cuts itself there.
    bool hold(const CutMesh& cut, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs, int rings) {
        std::vector<bool> now(m_held.size());
        for (const auto& [a, b] : pairs)
            for (const std::uint32_t t : {a, b})
                for (const std::uint32_t v : cut.mesh.triangles[t])
                    mark(cut, v, now);
        for (int ring = 0; ring < rings; ++ring) {
            const std::vector<bool> inner = now;
            for (const Triangle& t : m_triangles)
                if (inner[t[0]] || inner[t[1]] || inner[t[2]])
                    now[t[0]] = now[t[1]] = now[t[2]] = true;
        }
        bool more = false;
        for (std::size_t v = 0; v < now.size(); ++v) {
            more = more || (now[v] && !m_held[v] && m_onFaces[v].mixed);
            m_held[v] = m_held[v] || now[v];
        }
        return more;
    }
    std::vector<CreaseVertex> apply(std::vector<CreaseVertex> vertices, const Mesh& mesh) const {
        for (std::size_t v = 0; v < vertices.size(); ++v)
            if (m_held[v])
                vertices[v] = {{}, vertices[v].own, mesh.positions[v], mesh.normals[v], false};
        return vertices;
    }

  private:
    void mark(const CutMesh& cut, std::uint32_t v, std::vector<bool>& held) const {
        if (v < held.size())
            held[v] = true;
        else
            for (const std::uint32_t each : cut.between[v - held.size()])
                mark(cut, each, held);
    }

    std::span<const Triangle> m_triangles;
    std::span<const CreaseVertex> m_onFaces;
    std::vector<bool> m_held;
};

CutMesh cutAndShaped(const cells::CellSurface& cells, const Mesh& mesh, std::vector<CreaseVertex> onFaces,
                     CreaseMemory& memory, const base::Progress& progress) {
    CutMesh out = cutAtCreases(cells, mesh, std::move(onFaces), memory, progress);
    progress.step(1, "shaping triangles beside creases");
    tidyCreases(out);
    return out;
}

} // namespace

bool keepCreases(Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    const auto cells = cells::CellSurface::of(surface);
    if (!cells || mesh.triangles.empty())
        return false;
    progress.step(0, "finding creases");
    const std::vector<CreaseVertex> onFaces = ontoFaces(*cells, mesh);
    HeldVertices held(mesh, onFaces);
    CreaseMemory memory;
    CutMesh cut = cutAndShaped(*cells, mesh, onFaces, memory, process::part(progress, 0.3, 0.8));
    for (int round = 1;; ++round) {
        const base::Progress last =
            process::part(progress, 0.8 + 0.2 * (round - 1) / rounds, 0.8 + 0.2 * round / rounds);
        const auto cutting = untangle(cut.mesh, cut.before, shapeOf(cut.mesh).longestEdge, last);
        if (cutting.empty() || !held.hold(cut, cutting, round))
            break;
        if (round == rounds)
            return false;
        cut = cutAndShaped(*cells, mesh, held.apply(onFaces, mesh), memory, last);
    }
    mesh = std::move(cut.mesh);
    mesh.colours.clear();
    mesh.masks.clear();
    mesh.extra.clear();
    mesh.layout = surfel::AttributeLayout::none();
    dropUnused(mesh);
    takeAttributes(mesh, surface);
    return true;
}

} // namespace mesh
