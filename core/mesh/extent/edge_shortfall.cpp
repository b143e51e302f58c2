#include "core/mesh/extent/edge_shortfall.h"

#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/scratch.h"
#include "core/cells/cell_source.h"
#include "core/cells/feet.h"
#include "core/cells/labels.h"
#include "core/mesh/surface_traits.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mesh {

using base::Vec3d;

namespace {

constexpr std::size_t looked = 48;        ///< surfels, for one of the cell across
constexpr double stripWidth = 4;          ///< spacings of both sides that have the edge as theirs (cells/README 1.1)
constexpr double reachOfMesh = 3;         ///< cells: beyond that a mesh is gone
constexpr double farthestFoot = 3;        ///< spacings from a surfel to its edge
constexpr std::uint8_t sharpEnough = 200; ///< of 255: what fades ends nowhere in particular
constexpr double steepest = 3;            ///< tangent of half the angle of matter or air in the edge

/// The edge beside a surfel: where its plane and that of the cell across meet.
struct EdgeFoot {
    Vec3d place;
    double tangent = 0; ///< of half the angle in it
    double length = 0;  ///< that it stands for
    std::uint32_t own = 0, across = 0;
};

/// Planes of faces that bend meet beside their edge, and acutely far beside it: on to where both are zero.
void ontoSeam(cells::CellSource& source, EdgeFoot& foot) {
    source.moveTo(foot.place);
    if (source.find(foot.own) == cells::CellSource::none || source.find(foot.across) == cells::CellSource::none)
        return;
    cells::Feet feet(source, foot.place, {});
    const auto seam = feet.seam(foot.own, foot.across, foot.place);
    if (seam && distance(*seam, foot.place) < stripWidth * foot.length)
        foot.place = *seam;
}

double distanceSqTo(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
    const Vec3d way = b - a;
    const double along = lengthSq(way) > 0 ? std::clamp(dot(p - a, way) / lengthSq(way), 0.0, 1.0) : 0;
    return distanceSq(p, a + way * along);
}

double distanceSqTo(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d n = cross(b - a, c - a);
    if (dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 && dot(cross(a - c, p - c), n) >= 0 &&
        lengthSq(n) > 0)
        return dot(p - a, n) * dot(p - a, n) / lengthSq(n);
    return std::min({distanceSqTo(p, a, b), distanceSqTo(p, b, c), distanceSqTo(p, c, a)});
}

/// Triangles by the cells of space that their corners lie in, for those near the edges: triangles are no longer than
/// the cells are wide.
class NearTriangles {
  public:
    NearTriangles(const Mesh& mesh, double reach) : m_mesh(mesh), m_reach(reach) {}

    void want(const Vec3d& p) {
        base::forCellsAround(cellOf(p), [&](const base::Cell& cell) { m_cells.at(cell); });
    }
    void fill() {
        for (std::uint32_t t = 0; t < m_mesh.triangles.size(); ++t)
            for (const std::uint32_t corner : m_mesh.triangles[t]) {
                const base::Cell cell = cellOf(m_mesh.positions[corner]);
                if (!m_cells.find(cell))
                    continue;
                std::vector<std::uint32_t>& there = m_cells.at(cell);
                if (there.empty() || there.back() != t)
                    there.push_back(t);
            }
    }
    /// The reach where nothing is nearer.
    double distanceTo(const Vec3d& p) const {
        double least = m_reach * m_reach;
        base::forCellsAround(cellOf(p), [&](const base::Cell& cell) {
            if (const std::vector<std::uint32_t>* there = m_cells.find(cell))
                for (const std::uint32_t t : *there) {
                    const Triangle& f = m_mesh.triangles[t];
                    least = std::min(
                        least, distanceSqTo(p, m_mesh.positions[f[0]], m_mesh.positions[f[1]], m_mesh.positions[f[2]]));
                }
        });
        return std::sqrt(least);
    }

  private:
    base::Cell cellOf(const Vec3d& p) const { return base::cellOf(p, Vec3d(), 1 / m_reach); }

    const Mesh& m_mesh;
    double m_reach;
    base::CellMap<std::vector<std::uint32_t>> m_cells;
};

class Edges {
  public:
    Edges(const surface::Surface& surface, const cells::LabelLayout& labels)
        : m_tree(surface.tree()), m_labels(labels) {}

    std::optional<EdgeFoot> footOf(const surfel::SurfelBlock& block, int slot, double spacing) const {
        const cells::Label own = m_labels.at(block, slot);
        if (own.partner == own.cell || own.sharpness < sharpEnough)
            return {};
        const Vec3d p = base::cast<double>(block.position(slot)), n = base::cast<double>(block.normal(slot));
        static base::Scratch<std::vector<tree::Neighbour>> scratch;
        const auto near = scratch.take();
        m_tree.nearest(block.position(slot), looked, *near);
        for (const tree::Neighbour& other : *near) {
            if (m_labels.cellAt(*other.block, other.slot) != own.partner)
                continue;
            const Vec3d q = base::cast<double>(other.block->position(other.slot)),
                        m = base::cast<double>(other.block->normal(other.slot));
            const double cosine = dot(n, m), sineSq = 1 - cosine * cosine;
            if (!(sineSq > 1e-3))
                return {};
            const Vec3d way = (m - n * cosine) / sineSq; // along the own plane; moves by one in the other's height
            const Vec3d foot = p + way * dot(q - p, m);
            if (!(distance(foot, p) < farthestFoot * spacing))
                return {};
            return EdgeFoot{foot, std::min(steepest, std::sqrt(std::max(0.0, (1 + cosine) / (1 - cosine)))),
                            spacing / stripWidth, own.cell, own.partner};
        }
        return {};
    }

  private:
    const tree::SurfelTree& m_tree;
    const cells::LabelLayout& m_labels;
};

} // namespace

Shortfall shortfallAtEdges(const surface::Surface& surface, const Mesh& mesh, double cell,
                           const base::Progress& progress) {
    const std::optional<cells::LabelLayout> labels = cells::LabelLayout::of(*surface.tree().layout());
    const std::optional<cells::CellSurface> cells = cells::CellSurface::of(surface);
    if (!labels || !cells || !(cell > 0))
        return {};
    const Edges edges(surface, *labels);
    const double spacingsPerUnit = SurfaceTraits(surface).spacingsPerUnit;
    const tree::SurfelTree& tree = surface.tree();
    std::vector<std::vector<EdgeFoot>> feet(tree.blockCount());
    const auto look = [&] {
        if (progress.cancel && progress.cancel->load(std::memory_order_relaxed))
            throw base::Cancelled();
    };
    base::parallelFor(feet.size(), 1, [&](std::size_t number) {
        look();
        const surfel::BlockPtr block = tree.block(static_cast<std::uint32_t>(number));
        cells::CellSource source(*cells);
        for (int slot = 0; slot < block->size(); ++slot) {
            const float unit = surface::unitOf(surface.definition().weight, block->support(slot));
            if (auto foot = edges.footOf(*block, slot, spacingsPerUnit * static_cast<double>(unit))) {
                ontoSeam(source, *foot);
                feet[number].push_back(*foot);
            }
        }
    });
    NearTriangles triangles(mesh, reachOfMesh * cell);
    for (const auto& each : feet)
        for (const EdgeFoot& foot : each)
            triangles.want(foot.place);
    look();
    triangles.fill();
    std::vector<Shortfall> parts(feet.size());
    base::parallelFor(feet.size(), 1, [&](std::size_t number) {
        look();
        for (const EdgeFoot& foot : feet[number]) {
            const double gap = triangles.distanceTo(foot.place), t = foot.tangent;
            parts[number].volume += foot.length * gap * gap * t;
            parts[number].area += foot.length * 2 * gap * (std::sqrt(1 + t * t) - t);
        }
    });
    Shortfall out;
    for (const Shortfall& part : parts) {
        out.area += part.area;
        out.volume += part.volume;
    }
    return out;
}

} // namespace mesh
