#include "core/mesh/check/topology.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/edges.h"

#include <stdexcept>

namespace mesh {

namespace {

constexpr std::uint32_t none = ~0u;

class TopologyCount {
  public:
    TopologyCount(std::span<const Triangle> triangles, std::size_t vertices, std::span<const VertexKind> kinds)
        : m_triangles(triangles), m_kinds(kinds), m_used(vertices, false), m_uses(checked(triangles, vertices)) {}

    Topology run() {
        base::DisjointSets pieces(m_used.size());
        for (const Triangle& t : m_triangles)
            countFace(t, pieces);
        countVertices(pieces);
        countEdges();
        countSides(pieces);
        countFansAndLoops();
        return m_out;
    }

  private:
    static std::vector<EdgeUse> checked(std::span<const Triangle> triangles, std::size_t vertices) {
        for (const Triangle& t : triangles)
            if (std::max({t[0], t[1], t[2]}) >= vertices)
                throw std::out_of_range("a triangle names a vertex that is not there");
        return edgeUses(triangles);
    }

    void countFace(const Triangle& t, base::DisjointSets& pieces) {
        if (!isProper(t)) {
            ++m_out.improper;
            return;
        }
        ++m_out.faces;
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
        forEdges(m_uses, [&](std::span<const EdgeUse> edge) {
            ++m_out.edges;
            m_out.boundaryEdges += edge.size() == 1;
            m_out.nonManifoldEdges += edge.size() > 2;
            m_out.opposedEdges += edge.size() == 2 && edge[0].forward == edge[1].forward;
        });
    }

    /// A piece has one side where going around it turns a triangle over.
    void countSides(base::DisjointSets& pieces) {
        base::ParitySets sides(m_triangles.size());
        std::vector<bool> oneSided(m_used.size(), false);
        forEdges(m_uses, [&](std::span<const EdgeUse> edge) {
            if (edge.size() == 2 && !sides.relate(edge[0].face(), edge[1].face(), edge[0].forward == edge[1].forward)) {
                m_out.orientable = false;
                oneSided[pieces.find(edge[0].low)] = true;
            }
        });
        if (!m_out.orientable)
            for (std::uint32_t v = 0; v < m_used.size(); ++v)
                m_out.mixed |= m_used[v] && pieces.find(v) == v && !oneSided[v];
    }

    /// A fan is a class of corners that meet across manifold edges. An open one joins two ends of boundary edges.
    void countFansAndLoops() {
        base::DisjointSets fans(3 * m_triangles.size()), loops(m_uses.size());
        forEdges(m_uses, [&](std::span<const EdgeUse> edge) {
            if (edge.size() != 2)
                return;
            const bool opposed = edge[0].forward == edge[1].forward;
            fans.join(edge[0].corner, opposed ? edge[1].corner : edge[1].next());
            fans.join(edge[0].next(), opposed ? edge[1].next() : edge[1].corner);
        });
        countPinches(fans);
        std::vector<std::uint32_t> first(3 * m_triangles.size(), none);
        forBoundary([&](std::uint32_t use) {
            for (const std::uint32_t corner : {m_uses[use].corner, m_uses[use].next()}) {
                std::uint32_t& other = first[fans.find(corner)];
                if (other == none)
                    other = use;
                else
                    loops.join(other, use);
            }
        });
        countLoops(loops);
    }

    void countPinches(base::DisjointSets& fans) {
        std::vector<std::uint32_t> fanOf(m_used.size(), none);
        std::vector<bool> pinched(m_used.size(), false);
        for (std::uint32_t corner = 0; corner < 3 * m_triangles.size(); ++corner) {
            const Triangle& t = m_triangles[corner / 3];
            if (!isProper(t))
                continue;
            const std::uint32_t v = t[corner % 3], fan = fans.find(corner);
            if (fanOf[v] == none)
                fanOf[v] = fan;
            if (fanOf[v] != fan && !pinched[v]) {
                pinched[v] = true;
                ++m_out.nonManifoldVertices;
            }
        }
    }

    void countLoops(base::DisjointSets& loops) {
        std::vector<bool> fold(m_uses.size(), false);
        forBoundary([&](std::uint32_t use) {
            const auto isFold = [&](std::uint32_t v) { return !m_kinds.empty() && m_kinds[v] == VertexKind::Fold; };
            if (isFold(m_uses[use].low) || isFold(m_uses[use].high))
                fold[loops.find(use)] = true;
        });
        forBoundary([&](std::uint32_t use) {
            m_out.boundaryLoops += loops.find(use) == use;
            m_out.foldLoops += loops.find(use) == use && fold[use];
        });
    }

    template <class Fn>
    void forBoundary(const Fn& fn) const {
        forEdges(m_uses, [&](std::span<const EdgeUse> edge) {
            if (edge.size() == 1)
                fn(static_cast<std::uint32_t>(edge.data() - m_uses.data()));
        });
    }

    std::span<const Triangle> m_triangles;
    std::span<const VertexKind> m_kinds;
    std::vector<bool> m_used;
    std::vector<EdgeUse> m_uses;
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
