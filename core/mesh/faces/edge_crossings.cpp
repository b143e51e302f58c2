#include "core/mesh/faces/edge_crossings.h"

#include "core/base/segment.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double markDistance = 0.5; ///< spacings
constexpr double reach = 1.2;        ///< spacings: from an edge to a link over it, which cuts a corner
constexpr double pastEnd = 0.1;      ///< spacings: bent chains have gaps on one side
constexpr double apart = 0.1;        ///< of a link: crossings of two chains

} // namespace

double sideOf(const FaceTopology& topology, const SharpEdge& edge, const Vec3d& p) {
    const Vec3d y = base::nearestOnSegment(edge.from, edge.to, p);
    const double side = dot(p - y, topology.normals[edge.left] - topology.normals[edge.right]);
    return edge.convex ? side : -side;
}

EdgeCrossings::EdgeCrossings(const FaceTopology& topology, std::span<const FaceEdge> edges, double spacing)
    : m_topology(topology), m_edges(edges), m_spacing(spacing), m_side((reach + markDistance) * spacing) {
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        const std::size_t marks = marksOf(edges[i].edge);
        for (std::size_t k = 0; k <= marks; ++k) {
            std::vector<std::uint32_t>& there =
                m_grid.at(base::cellOf(markOf(edges[i].edge, k, marks), Vec3d(), 1 / m_side));
            if (there.empty() || there.back() != i)
                there.push_back(i);
        }
    }
}

std::size_t EdgeCrossings::marksOf(const SharpEdge& edge) const {
    return static_cast<std::size_t>(std::ceil(base::distance(edge.from, edge.to) / (markDistance * m_spacing))) + 1;
}

EdgeCrossings::Crossed EdgeCrossings::crossed(std::uint32_t face, const Vec3d& a, const Vec3d& b) const {
    Crossed out;
    std::array<double, 4> shares{}; // of the way, where it crosses
    base::forCellsAround(base::cellOf((a + b) / 2, Vec3d(), 1 / m_side), [&](const base::Cell& around) {
        const std::vector<std::uint32_t>* there = m_grid.find(around);
        for (std::size_t k = 0; there && k < there->size(); ++k) {
            const FaceEdge& each = m_edges[(*there)[k]];
            if (each.faces[0] != face && each.faces[1] != face)
                continue;
            const SharpEdge& edge = each.edge;
            const double sideA = sideOf(m_topology, edge, a), sideB = sideOf(m_topology, edge, b);
            if ((sideA > 0) == (sideB > 0))
                continue;
            const double share = sideA / (sideA - sideB);
            const Vec3d x = a + (b - a) * share;
            const double along = base::shareAlong(edge.from, edge.to, x);
            const double past = std::max(-along, along - 1) * base::distance(edge.from, edge.to);
            if (past > pastEnd * m_spacing ||
                base::distance(x, base::nearestOnSegment(edge.from, edge.to, x)) > reach * m_spacing)
                continue;
            const auto end = shares.begin() + std::min<int>(out.times, shares.size());
            if (std::any_of(shares.begin(), end, [&](double known) { return std::abs(known - share) < apart; }))
                continue;
            if (end != shares.end())
                *end = share;
            ++out.times;
            if (!out.edge || &each < out.edge)
                out.edge = &each;
        }
    });
    return out;
}

} // namespace mesh
