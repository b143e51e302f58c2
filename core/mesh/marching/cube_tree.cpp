#include "core/mesh/marching/cube_tree.h"

#include "core/base/parallel.h"

#include <cassert>

namespace mesh {

namespace {

/// fn(crossing) for the edges of one of the grid's own cubes. `nodes` tells their ranks.
template <class Ranks, class Fn>
void forCrossings(const SurfaceGrid& grid, const Ranks& nodes, const GridIndex& p, const Fn& fn) {
    for (int which = 0; which < 8; ++which) {
        const std::uint32_t node = nodes.rank(cornerOf(p, which));
        if (node == noRank)
            return;
        for (int axis = 0; axis < 3; ++axis)
            if (!(which >> axis & 1) && grid.crossingOf(node, axis) < SurfaceGrid::none)
                fn(grid.crossings()[grid.crossingOf(node, axis)]);
    }
}

template <class Fn>
void forAll(const SparseSet& set, const Fn& fn) {
    base::parallelFor(set.bricks().size(), 16,
                      [&](std::size_t b) { set.forMembers(static_cast<std::uint32_t>(b), fn); });
}

SparseSet chosen(const SparseSet& from, const std::vector<std::uint8_t>& which) {
    std::vector<BrickBits> bits;
    for (std::uint32_t b = 0; b < from.bricks().size(); ++b)
        from.forMembers(b, [&](const GridIndex& p, std::uint32_t rank) {
            if (which[rank])
                bits.push_back(bitsOf(p));
        });
    return SparseSet(std::move(bits));
}

} // namespace

CubeTree::CubeTree(const SurfaceGrid& grid, std::span<const LooseEnd> loose, double tolerance,
                   std::span<const SparseSet> apart)
    : m_grid(grid), m_tolerance(tolerance), m_apart(apart) {
    findActive(loose);
    for (int level = 1; level <= mostLevels && m_levels.back().joined.size() > 0; ++level)
        addLevel(level);
    m_large.resize(m_levels.size());
    for (std::size_t level = 1; level < m_levels.size(); ++level)
        for (std::uint32_t b = 0; b < m_levels[level].joined.bricks().size(); ++b)
            m_levels[level].joined.forMembers(b, [&](const GridIndex& p, std::uint32_t) {
                if (level + 1 == m_levels.size() || !m_levels[level + 1].joined.contains(halved(p)))
                    m_large[level].push_back(p);
            });
}

/// The grid's own cubes that have crossings; those beside loose ends never join.
void CubeTree::findActive(std::span<const LooseEnd> loose) {
    const SparseSet& nodes = m_grid.nodes();
    std::vector<std::uint8_t> any(nodes.size());
    base::parallelFor(nodes.bricks().size(), 16, [&](std::size_t b) {
        const Neighbourhood around(nodes, static_cast<std::uint32_t>(b));
        nodes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& p, std::uint32_t rank) {
            forCrossings(m_grid, around, p, [&](const Crossing&) { any[rank] = 1; });
        });
    });
    Level& finest = m_levels.emplace_back();
    finest.active = chosen(nodes, any);
    std::vector<std::uint8_t> free(finest.active.size(), 1);
    for (const LooseEnd& end : loose)
        for (const GridIndex& beside : {end.face.place, end.face.place.next(end.axis, -1)})
            if (const std::uint32_t rank = finest.active.rank(beside); rank != noRank)
                free[rank] = 0;
    finest.joined = chosen(finest.active, free);
}

void CubeTree::addLevel(int level) {
    const Level& finer = m_levels.back();
    std::vector<BrickBits> bits;
    for (std::uint32_t b = 0; b < finer.active.bricks().size(); ++b)
        finer.active.forMembers(b, [&](const GridIndex& p, std::uint32_t) { bits.push_back(bitsOf(halved(p))); });
    Level next;
    next.active = SparseSet(std::move(bits));
    next.moments.resize(next.active.size());
    std::vector<std::uint8_t> joined(next.active.size());
    forAll(next.active, [&](const GridIndex& p, std::uint32_t rank) {
        const GridIndex lowest = scaled(p, 1);
        for (int which = 0; which < 8; ++which)
            if (const std::uint32_t child = finer.active.rank(cornerOf(lowest, which)); child != noRank) {
                if (level > 1)
                    next.moments[rank].add(finer.moments[child]);
                else // those of the grid's own cubes would take more memory than all else
                    forCrossings(m_grid, m_grid.nodes(), cornerOf(lowest, which),
                                 [&](const Crossing& c) { next.moments[rank].add(c); });
            }
        joined[rank] = joins(p, level, next.moments[rank]) ? 1 : 0;
    });
    next.joined = chosen(next.active, joined);
    m_levels.push_back(std::move(next));
}

bool CubeTree::joins(const GridIndex& place, int level, const CrossingMoments& moments) const {
    const bool apart = std::size_t(level) < m_apart.size() && m_apart[std::size_t(level)].contains(place);
    return !apart && neighboursAreLarge(place, level) && flat(moments, level) && oneCrossingPerEdge(place, level) &&
           facesPair(place, level);
}

/// By heights over a plane and, for few crossings lie in one anyway, by how much normals turn.
bool CubeTree::flat(const CrossingMoments& moments, int level) const {
    constexpr double alike = 0.9; // of squared cosines, on average
    // the error of triangles on a sphere: over the root of mean squared heights, over side times that of sines
    constexpr double overRough = 3, overTurn = 0.25;
    const double side = m_grid.lattice().cell * (1 << level), likeness = moments.likeness();
    return likeness >= alike && overRough * std::sqrt(moments.roughness()) <= m_tolerance &&
           overTurn * side * std::sqrt(std::max(0.0, 1 - likeness)) <= m_tolerance;
}

/// Children and all cubes of their size around: none is split.
bool CubeTree::neighboursAreLarge(const GridIndex& place, int level) const {
    const GridIndex lowest = scaled(place, 1);
    for (int z = -1; z < 3; ++z)
        for (int y = -1; y < 3; ++y)
            for (int x = -1; x < 3; ++x) {
                const GridIndex p{lowest.x + x, lowest.y + y, lowest.z + z};
                const bool child = x >= 0 && x < 2 && y >= 0 && y < 2 && z >= 0 && z < 2;
                if ((child || level > 1) && split(p, level - 1))
                    return false;
            }
    return true;
}

/// Is it active, but not one cube? On the finest level: does it have to stay alone?
bool CubeTree::split(const GridIndex& place, int level) const {
    const Level& at = m_levels[std::size_t(level)];
    return at.active.contains(place) && !at.joined.contains(place);
}

/// The crossing of the fine edges along an edge, and how many there are.
std::uint32_t CubeTree::crossingAlong(const GridIndex& place, int level, int axis, int& count) const {
    std::uint32_t out = SurfaceGrid::none;
    count = 0;
    GridIndex p = scaled(place, level);
    for (int i = 0; i < 1 << level; ++i, ++p[axis]) {
        const std::uint32_t node = m_grid.nodes().rank(p);
        if (node == noRank || m_grid.crossingOf(node, axis) >= SurfaceGrid::none)
            continue;
        out = m_grid.crossingOf(node, axis);
        ++count;
    }
    return out;
}

bool CubeTree::oneCrossingPerEdge(const GridIndex& place, int level) const {
    for (int axis = 0; axis < 3; ++axis)
        for (int which = 0; which < 4; ++which) {
            const GridIndex at = place.next((axis + 1) % 3, which & 1).next((axis + 2) % 3, which >> 1);
            int count = 0;
            crossingAlong(at, level, axis, count);
            if (count > 1)
                return false;
        }
    return true;
}

GridFace CubeTree::face(const GridIndex& place, int level, int axis) const {
    GridFace out;
    out.place = place;
    out.axis = axis;
    for (int side = 0; side < 4; ++side) {
        const SurfaceGrid::EdgeName edge = GridFace::edge(place, axis, side);
        int count = 0;
        const std::uint32_t crossing = crossingAlong(edge.node, level, edge.axis, count);
        if (crossing >= SurfaceGrid::none)
            continue;
        out.crossing[std::size_t(out.count)] = crossing;
        out.side[std::size_t(out.count++)] = side;
    }
    return out;
}

bool CubeTree::facesPair(const GridIndex& place, int level) const {
    for (int axis = 0; axis < 3; ++axis)
        for (int above = 0; above < 2; ++above) {
            const GridFace at = face(place.next(axis, above), level, axis);
            const FacePairs pairs = pairsOf(m_grid, at);
            for (int i = 0; i < at.count; ++i)
                if (pairs.partner[std::size_t(i)] < 0)
                    return false;
        }
    return true;
}

bool CubeTree::covered(const GridIndex& place) const {
    return m_levels.size() > 1 && m_levels[1].joined.contains(halved(place));
}

/// fn(face) for a face of a cube, or for those of the smaller cubes on its other side, `towards` along the axis.
template <class Fn>
void CubeTree::forFaces(const GridIndex& place, int level, int axis, int towards, const Fn& fn) const {
    const GridIndex beside = towards > 0 ? place : place.next(axis, -1);
    if (level == 0 || !split(beside, level)) {
        fn(face(place, level, axis));
        return;
    }
    const GridIndex lowest = scaled(place, 1);
    for (int which = 0; which < 4; ++which)
        forFaces(lowest.next((axis + 1) % 3, which & 1).next((axis + 2) % 3, which >> 1), level - 1, axis, towards, fn);
}

void CubeTree::loopsOf(const GridIndex& place, int level, std::vector<Loop>& out) const {
    out.clear();
    CubeGraph graph;
    for (int axis = 0; axis < 3; ++axis)
        for (int above = 0; above < 2; ++above)
            forFaces(place.next(axis, above), level, axis, above ? 1 : -1, [&](const GridFace& at) {
                const FacePairs pairs = pairsOf(m_grid, at);
                for (int i = 0; i < at.count; ++i) {
                    const int j = pairs.partner[std::size_t(i)];
                    assert(j >= 0);
                    if (j > i)
                        graph.segment(at.crossing[std::size_t(i)], at.crossing[std::size_t(j)], 2 * axis + above);
                }
            });
    graph.loops(out);
}

} // namespace mesh
