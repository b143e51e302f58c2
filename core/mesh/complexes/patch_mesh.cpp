#include "core/mesh/complexes/patch_mesh.h"

#include "core/base/parallel.h"
#include "core/complexes/foot_on_cell.h"
#include "core/mesh/complexes/edge_counts.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/marching/marching_cubes.h"

#include <algorithm>
#include <limits>
#include <map>

namespace mesh {

using base::Vec3d, base::Vec3f;
using complexes::CellFoot, complexes::CellFrame;

namespace {

constexpr double nearRim = 0.3; ///< in cells: vertices so near to the boundary go there, so that no sliver is cut off

/// A place of a patch as its frame carries it on, and how far inside of the boundary it is; negative outside.
struct Placed {
    Vec3d position;
    Vec3f normal;
    double inside = std::numeric_limits<double>::infinity();
    std::uint32_t on = PatchMesh::inside;
    bool known = false;
};

class PatchCutter {
  public:
    PatchCutter(const complexes::Complex& complex, std::uint32_t patch, double cell)
        : m_complex(complex), m_patch(patch), m_cell(cell) {}

    /// Where a place near the patch belongs.
    Placed placed(const Vec3d& x, const Vec3f& normal) const {
        complexes::FootOptions free;
        free.restricted = false;
        free.side = base::cast<double>(normal);
        const CellFoot foot = footOn(m_complex, m_patch, x, free);
        Placed out;
        if (!foot.ok() || base::distance(foot.position, x) > 2 * m_cell)
            return out;
        const CellFrame frame = frameOf(m_complex, m_patch, foot.position, free.side);
        if (!frame.ok())
            return out;
        out.known = true;
        out.position = foot.position;
        out.normal = base::cast<float>(frame.axis);
        if (!frame.attached.empty())
            out.inside =
                frame.attached.front().distance * (isPast(m_complex, m_patch, foot.position, frame) ? -1.0 : 1.0);
        return out;
    }

    /// On the boundary, nearest to x.
    Placed onRim(const Vec3d& x, const Vec3f& normal) const {
        Placed out;
        double nearest = std::numeric_limits<double>::infinity();
        complexes::FootOptions anywhere;
        anywhere.projector = surface::Projector::Almost;
        anywhere.anywhere = true;
        for (const std::uint32_t b : m_complex[m_patch].boundary)
            if (const CellFoot foot = footOn(m_complex, b, x, anywhere);
                foot.ok() && base::distance(foot.position, x) < nearest) {
                nearest = base::distance(foot.position, x);
                out.position = foot.position;
                out.on = foot.on;
                out.known = true;
            }
        out.inside = 0;
        out.normal = normal;
        if (!out.known)
            return out;
        if (const CellFrame frame = frameOf(m_complex, m_patch, out.position, base::cast<double>(normal)); frame.ok())
            out.normal = base::cast<float>(frame.axis);
        return out;
    }

    /// Between a place inside and one outside: where the boundary is crossed.
    Placed crossing(Placed in, Placed past) const {
        for (int i = 0; i < 16; ++i) {
            const Placed middle = placed((in.position + past.position) * 0.5, in.normal);
            if (!middle.known)
                break;
            (middle.inside > 0 ? in : past) = middle;
        }
        return onRim((in.position + past.position) * 0.5, in.normal);
    }

  private:
    const complexes::Complex& m_complex;
    std::uint32_t m_patch;
    double m_cell;
};

/// Cuts triangles off where they pass the boundary.
class Clipping {
  public:
    Clipping(const PatchCutter& cutter, std::vector<Placed> vertices) : m_cutter(cutter), m_at(std::move(vertices)) {}

    void add(const Triangle& t) {
        if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return !m_at[v].known; }) ||
            std::none_of(t.begin(), t.end(), [&](std::uint32_t v) { return m_at[v].inside > 0; }))
            return;
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (m_at[a].inside >= 0)
                corners.push_back(a);
            if (m_at[a].inside * m_at[b].inside < 0)
                corners.push_back(between(a, b));
        }
        for (std::size_t k = 2; k < corners.size(); ++k)
            if (const Triangle made{corners[0], corners[k - 1], corners[k]}; isProper(made))
                triangles.push_back(made);
    }

    std::vector<Placed>& vertices() { return m_at; }
    std::vector<Triangle> triangles;

  private:
    std::uint32_t between(std::uint32_t a, std::uint32_t b) {
        const auto [at, fresh] = m_cut.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(m_at.size()));
        if (fresh) {
            const bool first = m_at[a].inside > 0;
            m_at.push_back(m_cutter.crossing(m_at[first ? a : b], m_at[first ? b : a]));
        }
        return at->second;
    }

    const PatchCutter& m_cutter;
    std::vector<Placed> m_at;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_cut;
};

} // namespace

PatchMesh meshOfPatch(const complexes::Complex& complex, std::uint32_t patch, double cell, const Vec3d& shift,
                      const base::Progress& progress) {
    MarchingOptions options;
    options.cell = cell;
    options.shift = shift;
    options.solid = false;
    options.creases = false;
    MarchingReport report;
    const Mesh whole = marchingCubes(complex[patch].own, options, report, progress);
    const PatchCutter cutter(complex, patch, report.cell);

    std::vector<Placed> at(whole.positions.size());
    base::parallelFor(at.size(), 16, [&](std::size_t v) {
        at[v] = cutter.placed(whole.positions[v], whole.normals[v]);
        if (at[v].known && std::abs(at[v].inside) < nearRim * report.cell)
            at[v] = cutter.onRim(at[v].position, at[v].normal);
    });
    Clipping clipping(cutter, std::move(at));
    for (const Triangle& t : whole.triangles)
        clipping.add(t);

    // Where the cubes ended before the boundary, the last vertices go there.
    std::vector<Placed>& vertices = clipping.vertices();
    if (!complex[patch].boundary.empty()) {
        const std::vector<bool> open = endsOfOpenEdges(clipping.triangles, vertices.size());
        for (std::size_t v = 0; v < open.size(); ++v)
            if (open[v] && vertices[v].on == PatchMesh::inside)
                vertices[v] = cutter.onRim(vertices[v].position, vertices[v].normal);
    }

    PatchMesh out;
    out.cell = report.cell;
    for (const Placed& each : vertices) {
        out.mesh.positions.push_back(each.position);
        out.mesh.normals.push_back(each.normal);
        out.mesh.kinds.push_back(VertexKind::Inner);
        out.on.push_back(each.on);
    }
    out.mesh.triangles = std::move(clipping.triangles);
    return out;
}

} // namespace mesh
