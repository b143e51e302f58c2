#include "core/mesh/marching/graded_grid.h"

#include "core/process/estimation/part_progress.h"
#include "core/surface/evaluation/packets.h"

#include <algorithm>

namespace mesh {

using base::Vec3d, base::Vec3f;
using Cube = CubeLevels::Cube;

namespace {

constexpr std::size_t cubesPerTask = 4096;

GridIndex placeOf(const Vec3d& grid, int level) {
    const auto of = [&](double x) { return static_cast<std::int32_t>(std::floor(std::ldexp(x, -level))); };
    return {of(grid.x), of(grid.y), of(grid.z)};
}

/// What parallel tasks gathered, by level.
void joinLevels(std::vector<std::vector<BrickBits>>& into, const std::vector<std::vector<BrickBits>>& more) {
    for (std::size_t level = 0; level < more.size(); ++level)
        into[level].insert(into[level].end(), more[level].begin(), more[level].end());
}

} // namespace

void GradedGrid::build(const base::Progress& progress) {
    if (m_traits.sided)
        m_solid.emplace(m_surface, process::part(progress, 0, 0.1));
    complete(discs(process::part(progress, 0.1, 0.2)), process::part(progress, 0.2, 1));
    number();
}

bool GradedGrid::reconsider(std::span<const GradedEdge> edges, const base::Progress& progress) {
    const base::Progress quiet{{}, progress.cancel};
    std::vector<std::uint8_t> before;
    for (const GradedEdge& edge : edges) {
        std::uint32_t& at = nodeAt(edge.node).edges[std::size_t(edge.axis)];
        before.push_back(at < none);
    }
    for (const GradedEdge& edge : edges)
        nodeAt(edge.node).edges[std::size_t(edge.axis)] = none;
    const std::vector<GradedEdge> crossed = walk(edges, Care::Thorough, quiet);
    bool changed = false;
    for (std::size_t i = 0; i < edges.size(); ++i)
        changed = changed || (nodeAt(edges[i].node).edges[std::size_t(edges[i].axis)] < none) != (before[i] != 0);
    complete(cubesAbout(crossed), quiet);
    number();
    return changed;
}

/// A disc of 0.75 spacings marks the cubes that it passes through, of whatever size.
void GradedGrid::addDisc(const Cube& cube, const Disc& disc, CubeBits& out) const {
    constexpr double radius = 0.75, slack = 0.05; // of the spacing; of a cube
    const double side = std::ldexp(1, cube.level);
    const Vec3d n = m_lattice.turned * disc.normal,
                middle = Vec3d{cube.place.x + 0.5, cube.place.y + 0.5, cube.place.z + 0.5} * side;
    const Vec3d to = middle - m_lattice.toGrid(disc.foot);
    const double reach = (0.5 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)) + slack) * side;
    const double widest = radius * m_traits.spacingsPerUnit * disc.unit / m_lattice.cell + 0.87 * side;
    if (std::abs(dot(to, n)) > reach || lengthSq(to) > widest * widest)
        return;
    if (!m_levels.isHalved(cube.place, cube.level)) {
        const Cube over = m_levels.cubeOver(cube.place, cube.level);
        out[std::size_t(over.level)].push_back(bitsOf(over.place));
        return;
    }
    for (int which = 0; which < 8; ++which)
        addDisc({cornerOf(scaled(cube.place, 1), which), cube.level - 1}, disc, out);
}

GradedGrid::CubeBits GradedGrid::discs(const base::Progress& progress) const {
    constexpr double radius = 0.75;
    const auto add = [&](const std::vector<Disc>& discs, CubeBits& out) {
        out.resize(m_cubes.size());
        for (const Disc& disc : discs) {
            const Vec3d centre = m_lattice.toGrid(disc.foot);
            const double wide = radius * m_traits.spacingsPerUnit * disc.unit / m_lattice.cell;
            const int level = std::clamp(std::ilogb(2 * wide), 0, m_levels.highest());
            const Vec3d around{wide, wide, wide};
            const GridIndex lo = placeOf(centre - around, level), hi = placeOf(centre + around, level);
            for (GridIndex p = lo; p.z <= hi.z; ++p.z)
                for (p.y = lo.y; p.y <= hi.y; ++p.y)
                    for (p.x = lo.x; p.x <= hi.x; ++p.x)
                        addDisc({p, level}, disc, out);
        }
        for (std::vector<BrickBits>& bits : out)
            joinBits(bits);
    };
    CubeBits out(m_cubes.size());
    for (const CubeBits& part : fromDiscs<CubeBits>(progress, add))
        joinLevels(out, part);
    return out;
}

void GradedGrid::complete(CubeBits cubes, const base::Progress& progress) {
    // the first round is nearly all of it
    for (int round = 0;; ++round) {
        const double from = 1 - std::pow(0.2, round), to = 1 - std::pow(0.2, round + 1), middle = 0.5 * (from + to);
        progress.step(from, "cutting cubes");
        const std::vector<Cube> fresh = add(cubes);
        if (fresh.empty())
            return;
        addNodes(fresh);
        evaluateNodes(process::part(progress, from, middle));
        cubes = cubesAbout(walk(openEdges(fresh), Care::Usual, process::part(progress, middle, to)));
    }
}

/// Returns those that were not there.
std::vector<Cube> GradedGrid::add(const CubeBits& cubes) {
    std::vector<Cube> fresh;
    for (int level = 0; level <= m_levels.highest(); ++level) {
        SparseSet& known = m_cubes[std::size_t(level)];
        std::vector<BrickBits> bits = cubes[std::size_t(level)];
        joinBits(bits);
        const std::size_t before = fresh.size();
        const SparseSet more(bits);
        for (std::uint32_t b = 0; b < more.bricks().size(); ++b)
            more.forMembers(b, [&](const GridIndex& p, std::uint32_t) {
                if (!known.contains(p))
                    fresh.push_back({p, level});
            });
        if (fresh.size() == before)
            continue;
        for (const SparseSet::Brick& brick : known.bricks())
            bits.push_back({brick.key, brick.mask});
        known = SparseSet(std::move(bits));
    }
    return fresh;
}

/// The ends of the cubes' edges; what is known stays known.
void GradedGrid::addNodes(std::span<const Cube> cubes) {
    std::vector<std::vector<BrickBits>> parts(base::chunkCount(cubes.size(), cubesPerTask));
    base::parallelChunks(cubes.size(), cubesPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (const Cube& cube : cubes.subspan(begin, end - begin))
            forEdges(cube, [&](const GradedEdge& edge) {
                parts[chunk].push_back(bitsOf(edge.node));
                parts[chunk].push_back(bitsOf(edge.node.next(edge.axis, 1 << edge.level)));
            });
        joinBits(parts[chunk]);
    });
    std::vector<BrickBits> bits;
    for (const SparseSet::Brick& brick : m_nodes.bricks())
        bits.push_back({brick.key, brick.mask});
    for (const auto& part : parts)
        bits.insert(bits.end(), part.begin(), part.end());
    SparseSet nodes(std::move(bits));
    if (nodes.size() > 0x50000000u)
        throw base::Error("the cell size makes more cubes than can be numbered", "", "choose larger cells");
    std::vector<Node> values(nodes.size());
    for (std::uint32_t b = 0; b < m_nodes.bricks().size(); ++b)
        m_nodes.forMembers(b, [&](const GridIndex& p, std::uint32_t rank) { values[nodes.rank(p)] = m_values[rank]; });
    m_nodes = std::move(nodes);
    m_values = std::move(values);
}

void GradedGrid::evaluateNodes(const base::Progress& progress) {
    constexpr std::size_t bricksAtOnce = 256;
    const auto evaluate = [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<Vec3f> x;
        std::vector<std::uint32_t> ranks;
        for (std::size_t b = begin; b < end; ++b)
            m_nodes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& place, std::uint32_t rank) {
                if (m_values[rank].known)
                    return;
                x.push_back(base::cast<float>(m_lattice.at(place)));
                ranks.push_back(rank);
            });
        const std::vector<NodeSide> sides = evaluated(x);
        for (std::size_t i = 0; i < x.size(); ++i) {
            m_values[ranks[i]].side = sides[i];
            m_values[ranks[i]].known = true;
        }
    };
    parallelSlabs(m_nodes.bricks().size(), bricksAtOnce, progress, "cutting cubes", evaluate);
}

/// Of some cubes the edges that nobody has looked at and that may cross; those that cannot are done with.
std::vector<GradedEdge> GradedGrid::openEdges(std::span<const Cube> cubes) {
    std::vector<GradedEdge> out;
    for (const Cube& cube : cubes)
        forEdges(cube, [&](const GradedEdge& edge) {
            Node& node = nodeAt(edge.node);
            std::uint32_t& at = node.edges[std::size_t(edge.axis)];
            if (at != unknown)
                return;
            at = none;
            if (mayCross(edgeOf(edge), node.side, endOf(edge)))
                out.push_back(edge);
        });
    return out;
}

std::vector<GradedEdge> GradedGrid::walk(std::span<const GradedEdge> edges, Care care, const base::Progress& progress) {
    constexpr std::size_t edgesPerTask = 4096;
    std::vector<std::optional<Crossing>> found(edges.size());
    const auto walkSome = [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<std::vector<std::size_t>> byLevel(m_cubes.size()); // packets reach as far as their edges
        for (std::size_t i = begin; i < end; ++i)
            byLevel[std::size_t(edges[i].level)].push_back(i);
        for (const std::vector<std::size_t>& some : byLevel) {
            std::vector<Vec3f> middles;
            double longest = 0;
            for (const std::size_t i : some) {
                const Edge edge = edgeOf(edges[i]);
                middles.push_back(base::cast<float>(edge.from + edge.direction * (0.5 * edge.length)));
                longest = edge.length;
            }
            surface::forPacketsWithin(m_surface, middles, 0.51 * longest, [&](surface::Source& source, std::size_t k) {
                const GradedEdge& edge = edges[some[k]];
                found[some[k]] = crossingOn(edgeOf(edge), nodeAt(edge.node).side, endOf(edge), source, care);
            });
        }
    };
    parallelSlabs(edges.size(), edgesPerTask, progress, "cutting cubes", walkSome);
    std::vector<GradedEdge> crossed;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (found[i]) {
            nodeAt(edges[i].node).edges[std::size_t(edges[i].axis)] = static_cast<std::uint32_t>(m_crossings.size());
            m_crossings.push_back(*found[i]);
            crossed.push_back(edges[i]);
        }
    return crossed;
}

/// The cubes about each edge, of whatever size.
GradedGrid::CubeBits GradedGrid::cubesAbout(std::span<const GradedEdge> edges) const {
    CubeBits out(m_cubes.size());
    for (const GradedEdge& edge : edges) {
        const int u = (edge.axis + 1) % 3, v = (edge.axis + 2) % 3;
        const GridIndex least = edge.node;
        const GridIndex place{least.x >> edge.level, least.y >> edge.level, least.z >> edge.level};
        for (int which = 0; which < 4; ++which) {
            const Cube cube = m_levels.cubeOver(place.next(u, -(which & 1)).next(v, -(which >> 1)), edge.level);
            if (!m_cubes[std::size_t(cube.level)].contains(cube.place))
                out[std::size_t(cube.level)].push_back(bitsOf(cube.place));
        }
    }
    return out;
}

/// Crossings in the order of their edges.
void GradedGrid::number() {
    std::vector<Crossing> sorted;
    sorted.reserve(m_crossings.size());
    for (Node& node : m_values)
        for (std::uint32_t& each : node.edges)
            if (each < none) {
                sorted.push_back(m_crossings[each]);
                each = static_cast<std::uint32_t>(sorted.size() - 1);
            }
    m_crossings = std::move(sorted);
}

/// fn(edge) for an edge, or for both of its halves.
template <class Fn>
void GradedGrid::halves(const GridIndex& node, int axis, int level, const Fn& fn) const {
    if (!m_levels.edgeIsHalved(node, axis, level))
        return fn(GradedEdge{scaled(node, level), axis, level});
    for (int half = 0; half < 2; ++half)
        fn(GradedEdge{scaled(scaled(node, 1).next(axis, half), level - 1), axis, level - 1});
}

template <class Fn>
void GradedGrid::forEdges(const Cube& cube, const Fn& fn) const {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int which = 0; which < 4; ++which)
            halves(cube.place.next(u, which & 1).next(v, which >> 1), axis, cube.level, fn);
        for (int above = 0; above < 2; ++above) { // the cross in a face of four
            const GridIndex face = cube.place.next(axis, above);
            if (!m_levels.faceIsQuartered(face, axis, cube.level))
                continue;
            const GridIndex low = scaled(face, 1);
            for (int half = 0; half < 2; ++half) {
                fn(GradedEdge{scaled(low.next(v).next(u, half), cube.level - 1), u, cube.level - 1});
                fn(GradedEdge{scaled(low.next(u).next(v, half), cube.level - 1), v, cube.level - 1});
            }
        }
    }
}

template <class Fn>
void GradedGrid::forSides(const GridIndex& place, int axis, int level, const Fn& fn) const {
    for (int side = 0; side < 4; ++side) {
        const SurfaceGrid::EdgeName edge = GridFace::edge(place, axis, side);
        std::array<GradedEdge, 2> some;
        std::size_t count = 0;
        halves(edge.node, edge.axis, level, [&](const GradedEdge& each) { some[count++] = each; });
        if (side >= 2) // these run back
            std::reverse(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
        for (std::size_t i = 0; i < count; ++i)
            fn(some[i], side);
    }
}

GridFace GradedGrid::leastFace(const GridIndex& place, int axis, int level) const {
    GridFace out;
    out.place = scaled(place, level);
    out.axis = axis;
    out.size = 1 << level;
    forSides(place, axis, level, [&](const GradedEdge& edge, int side) {
        const std::uint32_t rank = m_nodes.rank(edge.node);
        const std::uint32_t crossing = rank == noRank ? none : m_values[rank].edges[std::size_t(edge.axis)];
        if (crossing >= none)
            return;
        out.crossing[std::size_t(out.count)] = crossing;
        out.side[std::size_t(out.count++)] = side;
    });
    return out;
}

std::vector<GradedEdge> GradedGrid::edgesOf(const GridFace& face) const {
    std::vector<GradedEdge> out;
    const int level = std::countr_zero(static_cast<unsigned>(face.size));
    const GridIndex place{face.place.x >> level, face.place.y >> level, face.place.z >> level};
    forSides(place, face.axis, level, [&](const GradedEdge& edge, int) { out.push_back(edge); });
    return out;
}

} // namespace mesh
