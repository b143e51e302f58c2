#include "core/mesh/connectivity/boundary_loops.h"

#include <algorithm>

namespace mesh {

namespace {

class BoundaryWalk {
  public:
    explicit BoundaryWalk(const Triangulation& triangulation)
        : m_triangulation(triangulation), m_done(3 * std::size_t(triangulation.faceCount())) {}

    /// REQUIRES: `first` is on the boundary and on no loop yet.
    BoundaryLoop from(const Side& first) {
        BoundaryLoop out{first};
        done(first) = true;
        if (extend(out, m_triangulation.to(first)))
            return out;
        std::reverse(out.begin(), out.end());
        extend(out, m_triangulation.from(first));
        std::reverse(out.begin(), out.end());
        return out;
    }
    std::vector<bool>::reference done(const Side& s) { return m_done[3 * std::size_t(s.face) + std::size_t(s.k)]; }

  private:
    /// From the last side on over its end at `vertex`; returns whether the walk comes back to where it began.
    bool extend(BoundaryLoop& loop, std::uint32_t vertex) {
        for (;;) {
            const Side beside = m_triangulation.besideAt(loop.back(), vertex);
            const Side next = m_triangulation.turn(vertex, beside, [](std::uint32_t) {});
            if (!next.exists() || !m_triangulation.onBoundary(next))
                return false;
            if (done(next))
                return true;
            done(next) = true;
            loop.push_back(next);
            vertex = m_triangulation.otherEnd(next, vertex);
        }
    }

    const Triangulation& m_triangulation;
    std::vector<bool> m_done;
};

} // namespace

std::vector<BoundaryLoop> boundaryLoops(const Triangulation& triangulation) {
    BoundaryWalk walk(triangulation);
    std::vector<BoundaryLoop> out;
    triangulation.forSides([&](const Side& s) {
        if (triangulation.onBoundary(s) && !walk.done(s))
            out.push_back(walk.from(s));
    });
    return out;
}

std::vector<bool> boundaryVertices(const Triangulation& triangulation) {
    std::vector<bool> out(triangulation.vertexCount(), false);
    triangulation.forSides([&](const Side& s) {
        if (triangulation.onBoundary(s))
            out[triangulation.from(s)] = out[triangulation.to(s)] = true;
    });
    return out;
}

} // namespace mesh
