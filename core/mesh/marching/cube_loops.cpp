#include "core/mesh/marching/cube_loops.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace mesh {

LooseEnds::LooseEnds(const CrossingGrid& grid, std::vector<LooseEnd> ends, std::span<const TracedEnd> traced)
    : m_ends(std::move(ends)), m_partner(m_ends.size(), noRank) {
    const std::size_t crossings = grid.crossings().size();
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        if (m_partner[i] != noRank)
            continue;
        // a trace that left the face where another one begins joins the two
        for (std::size_t j = i + 1; j < m_ends.size() && m_ends[j].node == m_ends[i].node &&
                                    m_ends[j].axis == m_ends[i].axis && m_partner[i] == noRank;
             ++j) {
            const auto sideOf = [&](std::size_t e) { return m_ends[e].face.side[std::size_t(m_ends[e].index)]; };
            const bool there = traced[i].end == TraceEnd::Left && traced[i].side == sideOf(j);
            const bool back = traced[j].end == TraceEnd::Left && traced[j].side == sideOf(i);
            if (m_partner[j] != noRank || !(there || back))
                continue;
            m_partner[i] = m_ends[j].crossing();
            m_partner[j] = m_ends[i].crossing();
        }
        if (m_partner[i] != noRank)
            continue;
        m_partner[i] = static_cast<std::uint32_t>(crossings + m_boundary.size());
        m_boundary.push_back(static_cast<std::uint32_t>(i));
    }
}

std::uint32_t LooseEnds::partner(std::uint32_t node, int axis, std::uint32_t crossing) const {
    auto at =
        std::lower_bound(m_ends.begin(), m_ends.end(), std::tuple(node, axis),
                         [](const LooseEnd& end, const auto& key) { return std::tuple(end.node, end.axis) < key; });
    while (at->crossing() != crossing)
        ++at;
    assert(at->node == node && at->axis == axis);
    return m_partner[static_cast<std::size_t>(at - m_ends.begin())];
}

namespace {

bool anyCrossing(const SurfaceGrid& grid, const Neighbourhood& around, const GridIndex& place) {
    bool any = false;
    for (int corner = 0; corner < 8; ++corner) {
        const std::uint32_t node =
            around.rank(GridIndex{place.x + (corner & 1), place.y + (corner >> 1 & 1), place.z + (corner >> 2)});
        if (node == noRank)
            return false;
        for (int axis = 0; axis < 3; ++axis)
            any = any || (!(corner >> axis & 1) && grid.crossingOf(node, axis) < SurfaceGrid::none);
    }
    return any;
}

} // namespace

void loopsOf(const SurfaceGrid& grid, const LooseEnds& loose, const Neighbourhood& around, const GridIndex& place,
             std::vector<Loop>& out) {
    out.clear();
    if (!anyCrossing(grid, around, place))
        return;
    CubeGraph graph;
    GridFace face;
    for (int axis = 0; axis < 3; ++axis)
        for (int above = 0; above < 2; ++above) {
            const GridIndex base = place.next(axis, above);
            if (!faceAt(grid, around, base, axis, face) || face.count == 0)
                continue;
            const FacePairs pairs = pairsOf(grid, face);
            for (int i = 0; i < face.count; ++i) {
                const std::uint32_t a = face.crossing[std::size_t(i)];
                const int j = pairs.partner[std::size_t(i)];
                if (j > i)
                    graph.segment(a, face.crossing[std::size_t(j)], 2 * axis + above);
                else if (j < 0) {
                    const std::uint32_t b = loose.partner(around.rank(base), axis, a);
                    if (b >= grid.crossings().size() || a < b)
                        graph.segment(a, b, 2 * axis + above);
                }
            }
        }
    graph.loops(out);
}

} // namespace mesh
