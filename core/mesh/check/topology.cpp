#include "core/mesh/check/topology.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/connectivity/boundary_loops.h"
#include "core/mesh/connectivity/umbrellas.h"

#include <algorithm>
#include <stdexcept>

namespace mesh {

namespace {

std::span<const Triangle> checked(std::span<const Triangle> triangles, std::size_t vertices) {
    for (const Triangle& t : triangles)
        if (std::max({t[0], t[1], t[2]}) >= vertices)
            throw std::out_of_range("a triangle names a vertex that is not there");
    return triangles;
}

class TopologyCount {
  public:
    TopologyCount(std::span<const Triangle> triangles, std::size_t vertices, std::span<const VertexKind> kinds)
        : m_triangles(checked(triangles, vertices), vertices), m_kinds(kinds), m_used(vertices, false) {}

    Topology run() {
        base::DisjointSets pieces(m_used.size());
        for (std::uint32_t f = 0; f < m_triangles.faceCount(); ++f)
            countFace(f, pieces);
        countVertices(pieces);
        countEdges();
        countSides(pieces);
        countPinches();
        countLoops();
        return m_out;
    }

  private:
    void countFace(std::uint32_t face, base::DisjointSets& pieces) {
        if (!m_triangles.alive(face)) {
            ++m_out.improper;
            return;
        }
        ++m_out.faces;
        const Triangle& t = m_triangles.corners(face);
        pieces.join(t[0], t[1]);
        pieces.join(t[0], t[2]);
        m_used[t[0]] = m_used[t[1]] = m_used[t[2]] = true;
    }

    void countVertices(base::DisjointSets& pieces) {
        for (std::uint32_t v = 0; v < m_used.size(); ++v) {
            ++(m_used[v] ? m_out.vertices : m_out.unused);
            m_out.components += m_used[v] && pieces.find(v) == v;
        }
    }

    void countEdges() {
        m_triangles.forEdges([&](const Side& edge) {
            ++m_out.edges;
            if (m_triangles.onBoundary(edge))
                ++m_out.boundaryEdges;
            else if (!m_triangles.across(edge).exists())
                ++m_out.nonManifoldEdges;
            else if (!m_triangles.agrees(edge))
                ++m_out.opposedEdges;
        });
    }

    /// A piece has one side where going around it turns a triangle over.
    void countSides(base::DisjointSets& pieces) {
        base::ParitySets sides(m_triangles.faceCount());
        std::vector<bool> oneSided(m_used.size(), false);
        m_triangles.forEdges([&](const Side& edge) {
            const Side other = m_triangles.across(edge);
            if (other.exists() && !sides.relate(edge.face, other.face, !m_triangles.agrees(edge))) {
                m_out.orientable = false;
                oneSided[pieces.find(m_triangles.from(edge))] = true;
            }
        });
        if (!m_out.orientable)
            for (std::uint32_t v = 0; v < m_used.size(); ++v)
                m_out.mixed |= m_used[v] && pieces.find(v) == v && !oneSided[v];
    }

    /// Vertices of more than one umbrella.
    void countPinches() {
        const std::vector<std::uint32_t> umbrellas = umbrellasOf(m_triangles);
        std::vector<std::uint32_t> first(m_used.size(), Triangulation::none);
        std::vector<bool> pinched(m_used.size(), false);
        for (std::uint32_t corner = 0; corner < umbrellas.size(); ++corner) {
            if (umbrellas[corner] == Triangulation::none)
                continue;
            const std::uint32_t v = m_triangles.corners(corner / 3)[corner % 3];
            if (first[v] == Triangulation::none)
                first[v] = umbrellas[corner];
            pinched[v] = pinched[v] || first[v] != umbrellas[corner];
        }
        m_out.nonManifoldVertices = static_cast<std::size_t>(std::count(pinched.begin(), pinched.end(), true));
    }

    void countLoops() {
        const auto isFold = [&](std::uint32_t v) { return !m_kinds.empty() && m_kinds[v] == VertexKind::Fold; };
        for (const BoundaryLoop& loop : boundaryLoops(m_triangles)) {
            ++m_out.boundaryLoops;
            m_out.foldLoops += std::any_of(loop.begin(), loop.end(), [&](const Side& s) {
                return isFold(m_triangles.from(s)) || isFold(m_triangles.to(s));
            });
        }
    }

    Triangulation m_triangles;
    std::span<const VertexKind> m_kinds;
    std::vector<bool> m_used;
    Topology m_out;
};

} // namespace

std::optional<long long> Topology::genus() const {
    if (!manifold() || mixed)
        return std::nullopt;
    const long long twice = 2 * static_cast<long long>(components) - static_cast<long long>(boundaryLoops) - euler();
    return orientable ? twice / 2 : twice;
}

Topology topologyOf(std::span<const Triangle> triangles, std::size_t vertices, std::span<const VertexKind> kinds) {
    return TopologyCount(triangles, vertices, kinds).run();
}

} // namespace mesh
