#include "core/mesh/finish/close_folds.h"

#include "core/mesh/connectivity/boundary_loops.h"
#include "core/mesh/finish/own_sheet.h"

#include <algorithm>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

/// As its triangle runs.
struct LoopEdge {
    std::uint32_t from = 0, to = 0;
};

/// The fan that closes a loop.
class Fan {
  public:
    Fan(Mesh& mesh, std::span<const LoopEdge> loop) : m_mesh(mesh), m_loop(loop) {
        const Vec3f first = mesh.normals[loop[0].from];
        Vec3f normal;
        for (const LoopEdge& edge : loop) {
            m_middle.position += (at(edge.from) + at(edge.to)) / (2.0 * static_cast<double>(loop.size()));
            for (const std::uint32_t v : {edge.from, edge.to})
                normal += dot(mesh.normals[v], first) < 0 ? -mesh.normals[v] : mesh.normals[v];
        }
        m_middle.normal = normalized(normal, first);
    }

    /// Moves the middle onto the sheet around it; returns whether it is there.
    bool land(const surface::Surface& surface, const SurfaceTraits& traits, double cell) {
        const auto found = ontoOwnSheet(surface, traits, m_middle.position, m_middle.normal, 0.5 * cell);
        if (found)
            m_middle = *found;
        return found.has_value();
    }

    /// The mean of the loop's edges.
    double edgeLength() const {
        double sum = 0;
        for (const LoopEdge& edge : m_loop)
            sum += distance(m_mesh.positions[edge.from], m_mesh.positions[edge.to]);
        return sum / static_cast<double>(m_loop.size());
    }

    /// Do the normals around it and the loop face as the middle does?
    bool isOneSheet() const {
        constexpr double steepest = 0.5; // cosine
        const Vec3d normal = base::cast<double>(m_middle.normal);
        Vec3d all;
        for (const LoopEdge& edge : m_loop)
            all += area(edge);
        const auto facesAlike = [&](const LoopEdge& edge) {
            return std::abs(dot(base::cast<double>(m_mesh.normals[edge.from]), normal)) > steepest;
        };
        return std::abs(dot(base::normalized(all), normal)) > steepest &&
               std::all_of(m_loop.begin(), m_loop.end(), facesAlike);
    }

    std::uint32_t add() {
        const auto middle = static_cast<std::uint32_t>(m_mesh.positions.size());
        for (const LoopEdge& edge : m_loop) {
            m_mesh.kinds[edge.from] = m_mesh.kinds[edge.to] = VertexKind::Inner;
            m_mesh.triangles.push_back({edge.to, edge.from, middle});
        }
        m_mesh.positions.push_back(m_middle.position);
        m_mesh.normals.push_back(m_middle.normal);
        m_mesh.kinds.push_back(VertexKind::Inner);
        return middle;
    }

  private:
    const Vec3d& at(std::uint32_t v) const { return m_mesh.positions[v]; }
    Vec3d area(const LoopEdge& edge) const {
        return cross(at(edge.from) - m_middle.position, at(edge.to) - m_middle.position);
    }

    Mesh& m_mesh;
    std::span<const LoopEdge> m_loop;
    SurfacePoint m_middle;
};

} // namespace

std::vector<std::uint32_t> closeFolds(Mesh& mesh, const surface::Surface& surface, const FoldClosing& options) {
    const SurfaceTraits traits(surface);
    std::vector<std::uint32_t> middles;
    const Triangulation triangulation(mesh);
    std::vector<LoopEdge> loop;
    for (const BoundaryLoop& sides : boundaryLoops(triangulation)) {
        loop.clear();
        for (const Side& side : sides)
            loop.push_back({triangulation.from(side), triangulation.to(side)});
        const bool fold = std::any_of(loop.begin(), loop.end(), [&](const LoopEdge& edge) {
            return mesh.kinds[edge.from] == VertexKind::Fold || mesh.kinds[edge.to] == VertexKind::Fold;
        });
        if (!fold || loop.size() > options.longest)
            continue;
        Fan fan(mesh, loop);
        const bool goesOn =
            fan.land(surface, traits, options.cell > 0 ? options.cell : fan.edgeLength()) && fan.isOneSheet();
        if (options.everyLoop || (goesOn && loop.size() <= options.shortHole))
            middles.push_back(fan.add());
    }
    return middles;
}

} // namespace mesh
