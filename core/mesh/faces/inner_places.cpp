#include "core/mesh/faces/inner_places.h"

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesh {

namespace {

using base::Vec3d;

constexpr std::uint64_t seed = 0x696e6e6572ULL;
constexpr std::size_t probes = 20'000, probesPerBody = 8;
constexpr double onTop = 2e-6;   ///< of the extent: faces nearer than that are on top of each other
constexpr double leastCell = 64; ///< of that distance
/// Cells that all faces may be in, as often as they are: for each face, of few and of many.
constexpr double cellsOfFew = 100, cellsOfMany = 6, many = 4e6;
constexpr double leastShare = 0.01; ///< of the area, that is sampled in full
constexpr std::uint64_t axisBits = 21, axisMask = (1u << axisBits) - 1;

/// The axis that a normal is nearest to.
std::size_t longestAxis(const Vec3d& n) {
    std::size_t out = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(n[k]) > std::abs(n[out]))
            out = k;
    return out;
}

} // namespace

Vec3d InnerPlaces::corner(std::uint32_t triangle, std::size_t k) const {
    return base::cast<double>(m_positions[m_topology.triangles[triangle][k]]);
}

bool InnerPlaces::isSealed(std::uint32_t triangle) const {
    const std::uint32_t body = m_topology.bodies[triangle];
    return body != noBody && m_topology.sealed[body] != 0 && m_topology.areas[triangle] > 0;
}

InnerPlaces::InnerPlaces(const FaceTopology& topology, std::span<const base::Vec3f> positions)
    : m_topology(topology), m_positions(positions), m_cut(topology.sealed.size()) {
    base::Box3d box;
    std::size_t count = 0;
    double area = 0, edges = 0;
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t)
        if (isSealed(t)) {
            ++count;
            area += topology.areas[t];
            for (std::size_t k = 0; k < 3; ++k) {
                box.extend(corner(t, k));
                edges += distance(corner(t, k), corner(t, (k + 1) % 3));
            }
        }
    if (count == 0)
        return;
    m_tolerance = onTop * length(box.hi - box.lo);
    chooseSize(area, edges, count);
    m_lo = box.lo - Vec3d{m_size, m_size, m_size};
    fillCells();
    countInMiddles();
    probe();
}

/// A face is in two cells for each square of their size, and in more along its sides.
void InnerPlaces::chooseSize(double area, double edges, std::size_t count) {
    const auto n = static_cast<double>(count);
    const double most = std::max(cellsOfMany * n, std::min(cellsOfFew * n, many));
    m_size = std::max(leastCell * m_tolerance, std::sqrt(area / n) / 8);
    while (2 * area / (m_size * m_size) + 2 * edges / m_size > most)
        m_size *= 1.25;
}

std::uint64_t InnerPlaces::cellAt(const Vec3d& place) const {
    const auto at = [&](std::size_t k) { return static_cast<std::uint64_t>((place[k] - m_lo[k]) / m_size); };
    return at(1) << 2 * axisBits | at(2) << axisBits | at(0);
}

Vec3d InnerPlaces::middleOf(std::uint64_t cell) const {
    const auto at = [&](std::uint64_t number) { return (static_cast<double>(number) + 0.5) * m_size; };
    return m_lo + Vec3d{at(cell & axisMask), at(cell >> 2 * axisBits), at(cell >> axisBits & axisMask)};
}

std::span<const std::uint32_t> InnerPlaces::trianglesIn(std::size_t cell) const {
    return std::span(m_triangles).subspan(m_first[cell], m_first[cell + 1] - m_first[cell]);
}

/// Columns of cells along the axis that a face looks along most, of which its plane passes through a few.
void InnerPlaces::fillCells() {
    struct Entry {
        std::uint64_t cell;
        std::uint32_t triangle;
        auto operator<=>(const Entry&) const = default;
    };
    std::vector<std::vector<Entry>> parts(base::chunkCount(m_topology.triangles.size(), 4096));
    base::parallelChunks(m_topology.triangles.size(), 4096, [&](std::size_t begin, std::size_t end, std::size_t part) {
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
            if (!isSealed(t))
                continue;
            base::Box3d box;
            for (std::size_t k = 0; k < 3; ++k)
                box.extend(corner(t, k));
            const Vec3d& n = m_topology.normals[t];
            const std::size_t x = longestAxis(n), y = (x + 1) % 3, z = (x + 2) % 3;
            const double slack = 4 * m_tolerance;
            const auto number = [&](double value, std::size_t k) {
                return static_cast<std::int64_t>((value - m_lo[k]) / m_size);
            };
            const auto middle = [&](std::int64_t i, std::size_t k) {
                return m_lo[k] + (static_cast<double>(i) + 0.5) * m_size;
            };
            const double spread = m_size / 2 * (std::abs(n[y]) + std::abs(n[z])) / std::abs(n[x]) + 2 * slack;
            std::int64_t cell[3];
            for (cell[y] = number(box.lo[y] - slack, y); cell[y] <= number(box.hi[y] + slack, y); ++cell[y])
                for (cell[z] = number(box.lo[z] - slack, z); cell[z] <= number(box.hi[z] + slack, z); ++cell[z]) {
                    const double at = corner(t, 0)[x] - (n[y] * (middle(cell[y], y) - corner(t, 0)[y]) +
                                                         n[z] * (middle(cell[z], z) - corner(t, 0)[z])) /
                                                            n[x];
                    const std::int64_t last = number(std::min(at + spread, box.hi[x] + slack), x);
                    cell[x] = number(std::max(at - spread, box.lo[x] - slack), x);
                    for (; cell[x] <= last; ++cell[x])
                        parts[part].push_back({static_cast<std::uint64_t>(cell[1]) << 2 * axisBits |
                                                   static_cast<std::uint64_t>(cell[2]) << axisBits |
                                                   static_cast<std::uint64_t>(cell[0]),
                                               t});
                }
        }
    });
    std::vector<Entry> all;
    for (auto& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
        part = {};
    }
    std::sort(all.begin(), all.end());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (m_cells.empty() || m_cells.back() != all[i].cell) {
            m_cells.push_back(all[i].cell);
            m_first.push_back(i);
        }
        m_triangles.push_back(all[i].triangle);
    }
    m_first.push_back(static_cast<std::uint32_t>(all.size()));
}

/// Whether a line along the axis through the place crosses the triangle. What runs through an edge belongs to one side
/// of it alone: sides are compared from their lower place on, so that both triangles reckon the same.
bool InnerPlaces::isOver(const Vec3d& place, std::uint32_t triangle, std::size_t axis) const {
    const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
    bool odd = false;
    for (std::size_t k = 0, l = 2; k < 3; l = k++) {
        const base::Vec3f &p = m_positions[m_topology.triangles[triangle][k]],
                          &q = m_positions[m_topology.triangles[triangle][l]];
        const bool up = p[y] < q[y];
        const double ay = up ? p[y] : q[y], az = up ? p[z] : q[z], by = up ? q[y] : p[y], bz = up ? q[z] : p[z];
        odd ^= (ay <= place[y]) & (place[y] < by) & ((bz - az) * (place[y] - ay) > (place[z] - az) * (by - ay));
    }
    return odd && m_topology.normals[triangle][axis] != 0;
}

/// Along every line of cells from where nothing is yet.
void InnerPlaces::countInMiddles() {
    m_turns.resize(m_cells.size());
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < m_cells.size(); ++i)
        if (i == 0 || m_cells[i] >> axisBits != m_cells[i - 1] >> axisBits)
            lines.push_back(i);
    lines.push_back(m_cells.size());
    base::parallelFor(lines.size() - 1, 64, [&](std::size_t line) {
        struct Crossing {
            double at;
            std::uint32_t triangle;
            auto operator<=>(const Crossing&) const = default;
        };
        std::vector<Crossing> crossings;
        const Vec3d middle = middleOf(m_cells[lines[line]]);
        for (std::size_t i = lines[line]; i < lines[line + 1]; ++i)
            for (const std::uint32_t t : trianglesIn(i))
                if (isOver(middle, t, 0))
                    crossings.push_back(
                        {middle.x + dot(corner(t, 0) - middle, m_topology.normals[t]) / m_topology.normals[t].x, t});
        std::sort(crossings.begin(), crossings.end());
        crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
        std::size_t next = 0;
        int turns = 0;
        for (std::size_t i = lines[line]; i < lines[line + 1]; ++i) {
            for (; next < crossings.size() && crossings[next].at < middleOf(m_cells[i]).x; ++next)
                turns -= m_topology.normals[crossings[next].triangle].x > 0 ? 1 : -1;
            m_turns[i] = turns;
        }
    });
}

/// On a straight way from the place to the middle of its cell.
int InnerPlaces::turnsAt(std::size_t cell, const Vec3d& place) const {
    const Vec3d middle = middleOf(m_cells[cell]);
    int out = m_turns[cell];
    for (const std::uint32_t t : trianglesIn(cell)) {
        const Vec3d &n = m_topology.normals[t], a = corner(t, 0);
        const double from = dot(n, place - a), to = dot(n, middle - a);
        if ((from > 0) == (to > 0))
            continue;
        if (isOver(place + (middle - place) * (from / (from - to)), t, longestAxis(n)))
            out += to > 0 ? 1 : -1;
    }
    return out;
}

InnerPlaces::Turns InnerPlaces::turnsAround(const Vec3d& place, std::uint32_t triangle) const {
    const auto found = std::lower_bound(m_cells.begin(), m_cells.end(), cellAt(place));
    if (found == m_cells.end() || *found != cellAt(place))
        return {0, 1};
    const auto cell = static_cast<std::size_t>(found - m_cells.begin());
    const Vec3d away = m_topology.normals[triangle] * (2 * m_tolerance); // past what lies on top of it
    return {turnsAt(cell, place + away), turnsAt(cell, place - away)};
}

/// What is inside on both sides is found on some places of each body, even by area. Where all of them are as deep, it
/// is wholly outside, or wholly inside of something else.
void InnerPlaces::probe() {
    const std::size_t size = m_topology.triangles.size(), bodies = m_cut.size();
    std::vector<double> areas(bodies);
    std::vector<std::uint32_t> order;
    double sealed = 0;
    for (std::uint32_t t = 0; t < size; ++t)
        if (isSealed(t) && m_topology.areas[t] > 0) {
            areas[m_topology.bodies[t]] += m_topology.areas[t];
            sealed += m_topology.areas[t];
            order.push_back(t);
        }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return m_topology.bodies[a] < m_topology.bodies[b]; });
    struct Probe {
        Vec3d place;
        std::uint32_t triangle;
        double weight; ///< area that it stands for
        Turns turns;
    };
    std::vector<Probe> all;
    double sum = 0, next = 0; // of the body's area so far; where the next probe is
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t t = order[i], body = m_topology.bodies[t];
        const auto wanted = static_cast<double>(probesPerBody) + std::floor(probes * areas[body] / sealed);
        const double step = areas[body] / wanted;
        if (i == 0 || m_topology.bodies[order[i - 1]] != body)
            sum = 0, next = step / 2;
        for (sum += m_topology.areas[t]; next < sum; next += step) {
            base::Random random(base::mix(seed ^ all.size()));
            double u = random.uniform(), v = random.uniform();
            if (u + v > 1)
                u = 1 - u, v = 1 - v;
            const Vec3d a = corner(t, 0);
            all.push_back({a + (corner(t, 1) - a) * u + (corner(t, 2) - a) * v, t, step, {}});
        }
    }
    base::parallelFor(all.size(), 256,
                      [&](std::size_t i) { all[i].turns = turnsAround(all[i].place, all[i].triangle); });
    double inner = 0;
    for (std::size_t begin = 0, end; begin < all.size(); begin = end) {
        const std::uint32_t body = m_topology.bodies[all[begin].triangle];
        double inside = 0;
        bool same = true;
        for (end = begin; end < all.size() && m_topology.bodies[all[end].triangle] == body; ++end) {
            const auto& [outside, within] = all[end].turns;
            inside += outside >= 1 && within >= 1 ? all[end].weight : 0;
            same &= outside == all[begin].turns.outside;
        }
        m_cut[body] = !same && inside > 0;
        inner += m_cut[body] ? inside : 0;
    }
    m_outerShare = std::max(leastShare, 1 - inner / m_topology.area);
}

bool InnerPlaces::has(const Vec3d& place, std::uint32_t triangle) const {
    if (!isSealed(triangle) || !m_cut[m_topology.bodies[triangle]])
        return false;
    const Turns turns = turnsAround(place, triangle);
    return turns.outside >= 1 && turns.inside >= 1;
}

} // namespace mesh
