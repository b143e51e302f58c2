#include "core/mesh/marching/surface_grid.h"

#include "core/mesh/marching/slabs.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/evaluation/packets.h"

#include <numeric>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t bricksPerTask = 64;
constexpr const char* step = "cutting cubes";

/// What parallel tasks gathered, in their order.
template <class T>
std::vector<T> joined(const std::vector<std::vector<T>>& parts) {
    std::vector<T> out;
    out.reserve(std::transform_reduce(parts.begin(), parts.end(), std::size_t(0), std::plus<>(),
                                      [](const auto& part) { return part.size(); }));
    for (const auto& part : parts)
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

GridIndex placeOf(const Vec3d& grid) {
    return {static_cast<std::int32_t>(std::floor(grid.x)), static_cast<std::int32_t>(std::floor(grid.y)),
            static_cast<std::int32_t>(std::floor(grid.z))};
}

/// The cubes that a disc passes through. Grid coordinates.
void addDisc(const Vec3d& centre, const Vec3d& normal, double radius, std::vector<BrickBits>& out) {
    constexpr double slack = 0.05;
    const double reach = 0.5 * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z)) + slack;
    const double widest = (radius + 0.5) * (radius + 0.5);
    const Vec3d side{radius, radius, radius};
    const GridIndex lo = placeOf(centre - side), hi = placeOf(centre + side);
    for (GridIndex p = lo; p.z <= hi.z; ++p.z)
        for (p.y = lo.y; p.y <= hi.y; ++p.y)
            for (p.x = lo.x; p.x <= hi.x; ++p.x) {
                const Vec3d to = Vec3d{p.x + 0.5, p.y + 0.5, p.z + 0.5} - centre;
                if (std::abs(dot(to, normal)) <= reach && lengthSq(to) <= widest + 0.5)
                    out.push_back(bitsOf(p));
            }
    out.push_back(bitsOf(placeOf(centre)));
}

} // namespace

SurfaceGrid::SurfaceGrid(const surface::Surface& surface, const SurfaceTraits& traits, const Lattice& lattice)
    : CrossingGrid(surface, traits, lattice) {}

void SurfaceGrid::build(const base::Progress& progress) {
    if (m_traits.sided)
        m_solid.emplace(m_surface, process::part(progress, 0, 0.1));
    complete(discs(process::part(progress, 0.1, 0.2)), process::part(progress, 0.2, 1));
    number();
}

bool SurfaceGrid::reconsider(std::span<const EdgeName> edges, const base::Progress& progress) {
    const base::Progress quiet{{}, progress.cancel};
    std::vector<Job> jobs;
    for (const EdgeName& edge : edges)
        jobs.push_back({edge.node, m_nodes.rank(edge.node), m_nodes.rank(edge.node.next(edge.axis)), edge.axis});
    const std::vector<Found> found = walk(jobs, Care::Thorough, quiet);
    bool changed = false;
    auto next = found.begin();
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const bool crosses = next != found.end() && next->job == i;
        next += crosses ? 1 : 0;
        std::uint32_t& at = m_edges[3 * std::size_t(jobs[i].first) + static_cast<std::size_t>(jobs[i].axis)];
        changed = changed || (at < none) != crosses;
        at = none;
    }
    const std::vector<Job> crossed = take(jobs, found);
    complete(cubesAbout(crossed), quiet);
    number();
    return changed;
}

/// Numbers the crossings found; returns their edges.
std::vector<SurfaceGrid::Job> SurfaceGrid::take(std::span<const Job> jobs, std::span<const Found> found) {
    std::vector<Job> crossed;
    crossed.reserve(found.size());
    for (const Found& each : found) {
        const Job& job = jobs[each.job];
        m_edges[3 * std::size_t(job.first) + std::size_t(job.axis)] = static_cast<std::uint32_t>(m_crossings.size());
        m_crossings.push_back(each.crossing);
        crossed.push_back(job);
    }
    return crossed;
}

/// Where surfels' tangent discs on the surface pass.
std::vector<BrickBits> SurfaceGrid::discs(const base::Progress& progress) const {
    constexpr double radius = 0.75; // of the spacing
    return joined(
        fromDiscs<std::vector<BrickBits>>(progress, [&](const std::vector<Disc>& discs, std::vector<BrickBits>& out) {
            for (const Disc& disc : discs)
                addDisc(m_lattice.toGrid(disc.foot), m_lattice.turned * disc.normal,
                        radius * m_traits.spacingsPerUnit * disc.unit / m_lattice.cell, out);
            joinBits(out);
        }));
}

void SurfaceGrid::complete(std::vector<BrickBits> cubes, const base::Progress& progress) {
    // the first round is nearly all of it
    for (int round = 0; !cubes.empty(); ++round) {
        const double from = 1 - std::pow(0.2, round), to = 1 - std::pow(0.2, round + 1), middle = 0.5 * (from + to);
        progress.step(from, step);
        add(std::move(cubes));
        evaluateNodes(process::part(progress, from, middle));
        const std::vector<Job> jobs = openEdges();
        cubes = cubesAbout(take(jobs, walk(jobs, Care::Usual, process::part(progress, middle, to))));
    }
}

/// The corners of more cubes become nodes; what is known stays known.
void SurfaceGrid::add(std::vector<BrickBits> cubes) {
    SparseSet nodes = cornersOf(SparseSet(std::move(cubes)), m_nodes);
    if (nodes.size() > 0x50000000u)
        throw base::Error("the cell size makes more cubes than can be numbered", "", "choose larger cells");
    std::vector<NodeValue> values(nodes.size());
    std::vector<std::uint8_t> known(nodes.size());
    std::vector<SolidSide> sides(m_solid ? nodes.size() : 0);
    std::vector<std::uint32_t> edges(3 * nodes.size(), unknown);
    base::parallelFor(m_nodes.bricks().size(), bricksPerTask, [&](std::size_t b) {
        const SparseSet::Brick& before = m_nodes.bricks()[b];
        const SparseSet::Brick& now = nodes.bricks()[nodes.find(before.key)];
        std::uint32_t from = before.first;
        for (std::uint64_t rest = before.mask; rest; rest &= rest - 1, ++from) {
            const std::uint32_t to = rankIn(now, std::countr_zero(rest));
            values[to] = m_values[from];
            known[to] = m_known[from];
            if (m_solid)
                sides[to] = m_sides[from];
            std::copy_n(&m_edges[3 * std::size_t(from)], 3, &edges[3 * std::size_t(to)]);
        }
    });
    m_nodes = std::move(nodes);
    m_values = std::move(values);
    m_known = std::move(known);
    m_sides = std::move(sides);
    m_edges = std::move(edges);
}

void SurfaceGrid::evaluateNodes(const base::Progress& progress) {
    constexpr std::size_t bricksAtOnce = 128;
    parallelSlabs(
        m_nodes.bricks().size(), bricksAtOnce, progress, step, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<Vec3f> x;
            std::vector<std::uint32_t> ranks;
            for (std::size_t b = begin; b < end; ++b)
                m_nodes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& place, std::uint32_t rank) {
                    if (m_known[rank])
                        return;
                    x.push_back(base::cast<float>(m_lattice.at(place)));
                    ranks.push_back(rank);
                });
            const std::vector<NodeSide> sides = evaluated(x);
            for (std::size_t i = 0; i < x.size(); ++i) {
                m_values[ranks[i]] = sides[i].value;
                if (m_solid)
                    m_sides[ranks[i]] = sides[i].side;
                m_known[ranks[i]] = 1;
            }
        });
}

/// Edges between nodes that nobody has looked at and that may cross; those that cannot are done with.
std::vector<SurfaceGrid::Job> SurfaceGrid::openEdges() {
    const std::size_t bricks = m_nodes.bricks().size();
    std::vector<std::vector<Job>> parts(base::chunkCount(bricks, bricksPerTask));
    base::parallelChunks(bricks, bricksPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        const auto look = [&](const Neighbourhood& around, const GridIndex& p, std::uint32_t n, int axis) {
            const std::uint32_t last = around.rank(p.next(axis));
            std::uint32_t& at = m_edges[3 * std::size_t(n) + std::size_t(axis)];
            if (last == noRank || at != unknown)
                return;
            at = none;
            if (mayCross(edgeOf(p, axis), sideOf(n), sideOf(last)))
                parts[chunk].push_back({p, n, last, axis});
        };
        for (std::size_t b = begin; b < end; ++b) {
            const Neighbourhood around(m_nodes, static_cast<std::uint32_t>(b));
            m_nodes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& p, std::uint32_t n) {
                for (int axis = 0; axis < 3; ++axis)
                    look(around, p, n, axis);
            });
        }
    });
    return joined(parts);
}

std::vector<SurfaceGrid::Found> SurfaceGrid::walk(std::span<const Job> jobs, Care care,
                                                  const base::Progress& progress) const {
    constexpr std::size_t jobsPerTask = 8192;
    std::vector<std::vector<Found>> parts(base::chunkCount(jobs.size(), jobsPerTask));
    parallelSlabs(jobs.size(), jobsPerTask, progress, step, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        std::vector<Vec3f> middles;
        for (const Job& job : jobs.subspan(begin, end - begin)) {
            const Edge edge = edgeOf(job.node, job.axis);
            middles.push_back(base::cast<float>(edge.from + edge.direction * (0.5 * edge.length)));
        }
        std::vector<std::optional<Crossing>> found(middles.size());
        surface::forPacketsWithin(
            m_surface, middles, 0.51 * m_lattice.cell, [&](surface::Source& source, std::size_t i) {
                const Job& job = jobs[begin + i];
                found[i] = crossingOn(edgeOf(job.node, job.axis), sideOf(job.first), sideOf(job.last), source, care);
            });
        for (std::size_t i = 0; i < found.size(); ++i)
            if (found[i])
                parts[chunk].push_back({begin + i, *found[i]});
    });
    return joined(parts);
}

/// The four cubes about each edge that lack corners.
std::vector<BrickBits> SurfaceGrid::cubesAbout(std::span<const Job> jobs) const {
    constexpr std::size_t jobsPerTask = 4096;
    std::vector<std::vector<BrickBits>> parts(base::chunkCount(jobs.size(), jobsPerTask));
    base::parallelChunks(jobs.size(), jobsPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        std::optional<Neighbourhood> around;
        for (const Job& job : jobs.subspan(begin, end - begin)) {
            if (const std::uint64_t key = brickKey(job.node); !around || !(around->lowest() == lowestOf(key)))
                around.emplace(m_nodes, m_nodes.find(key), true);
            const int u = (job.axis + 1) % 3, v = (job.axis + 2) % 3;
            // the edge is there: a cube lacks corners where another of its edges along the axis does
            bool there[3][3];
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b) {
                    const GridIndex end0 = job.node.next(u, a - 1).next(v, b - 1);
                    there[a][b] = around->rank(end0) != noRank && around->rank(end0.next(job.axis)) != noRank;
                }
            for (int a = 0; a < 2; ++a)
                for (int b = 0; b < 2; ++b)
                    if (!(there[a][b] && there[a + 1][b] && there[a][b + 1] && there[a + 1][b + 1]))
                        parts[chunk].push_back(bitsOf(job.node.next(u, a - 1).next(v, b - 1)));
        }
        joinBits(parts[chunk]);
    });
    return joined(parts);
}

/// Crossings in the order of their edges.
void SurfaceGrid::number() {
    std::vector<Crossing> sorted;
    sorted.reserve(m_crossings.size());
    for (std::uint32_t& each : m_edges)
        if (each < none) {
            sorted.push_back(m_crossings[each]);
            each = static_cast<std::uint32_t>(sorted.size() - 1);
        }
    m_crossings = std::move(sorted);
}

} // namespace mesh
