#include "core/mesh/faces/winding_cells.h"

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

namespace mesh {

namespace {

using base::Vec3d;

constexpr std::uint64_t seed = 0x63656c6c73ULL;
/// Faces that came from one number, computed twice: of their coordinates, and of their extent.
constexpr double ofCoordinates = 5e-7, ofExtent = 1.5e-6;
constexpr double leastCell = 64; ///< of the distance at which faces are on top of each other
constexpr std::size_t fewFaces = 12;
constexpr int mostLevels = 24;
/// Of all triangles in all cells, how many: for each face, of few and of many.
constexpr double ofFew = 100, ofMany = 8, many = 4e6;

/// The axis that a normal is nearest to.
std::size_t longestAxis(const Vec3d& n) {
    std::size_t out = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(n[k]) > std::abs(n[out]))
            out = k;
    return out;
}

double largest(const Vec3d& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

} // namespace

WindingCells::WindingCells(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                           const std::vector<std::uint32_t>& sealed)
    : m_topology(topology), m_positions(positions), m_triangles(sealed) {
    base::Box3d box;
    Cell root;
    for (const std::uint32_t t : sealed) {
        for (std::size_t k = 0; k < 3; ++k)
            box.extend(corner(t, k));
        root.onTop = std::max(root.onTop, onTop(t));
    }
    if (sealed.empty())
        return;
    // Of round binary numbers, so that corners of cells are computed exactly.
    root.size = std::exp2(std::ceil(std::log2(1.01 * largest(box.hi - box.lo) + leastCell * root.onTop)));
    const double grain = std::ldexp(root.size, -6);
    for (std::size_t k = 0; k < 3; ++k)
        root.lo[k] = std::floor((box.lo[k] + box.hi[k] - root.size) / 2 / grain) * grain;
    root.size *= 2; // what that moved it by is less than it grows
    root.end = static_cast<std::uint32_t>(sealed.size());
    root.place = root.lo; // outside of all
    m_cells.push_back(root);
    std::stable_sort(m_triangles.begin(), m_triangles.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return m_topology.bodies[a] < m_topology.bodies[b]; });
    findHoles();
    halveAll();
}

Vec3d WindingCells::corner(std::uint32_t triangle, std::size_t k) const {
    return base::cast<double>(m_positions[m_topology.triangles[triangle][k]]);
}

double WindingCells::onTop(std::uint32_t triangle) const {
    base::Box3d box;
    for (std::size_t k = 0; k < 3; ++k)
        box.extend(corner(triangle, k));
    return ofCoordinates * std::max(largest(box.lo), largest(box.hi)) + ofExtent * largest(box.hi - box.lo);
}

/// Whether box and plane of the triangle meet the cell, and somewhat beyond.
bool WindingCells::meets(std::uint32_t triangle, const Cell& cell) const {
    const double slack = 4 * onTop(triangle), half = cell.size / 2 + slack;
    const Vec3d middle = cell.lo + Vec3d{1, 1, 1} * (cell.size / 2), &n = m_topology.normals[triangle];
    base::Box3d box;
    for (std::size_t k = 0; k < 3; ++k)
        box.extend(corner(triangle, k) - middle);
    for (std::size_t k = 0; k < 3; ++k)
        if (box.lo[k] > half || box.hi[k] < -half)
            return false;
    return std::abs(dot(corner(triangle, 0) - middle, n)) <= half * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
}

void WindingCells::findHoles() {
    std::vector<double> volumes(m_topology.sealed.size());
    // About a place of the body itself: seams are closed but for rounding, which grows with the distance.
    constexpr std::uint32_t noTriangle = ~0u;
    std::vector<std::uint32_t> first(volumes.size(), noTriangle);
    for (const std::uint32_t t : m_triangles) {
        const std::uint32_t body = m_topology.bodies[t];
        if (first[body] == noTriangle)
            first[body] = t;
        volumes[body] += dot(corner(t, 0) - corner(first[body], 0), m_topology.normals[t]) * m_topology.areas[t];
    }
    m_holes.resize(volumes.size());
    std::transform(volumes.begin(), volumes.end(), m_holes.begin(), [](double v) { return v < 0 ? 1 : 0; });
}

/// A cell's children with what is in them.
struct WindingCells::Halved {
    std::array<Cell, 8> cells;
    std::array<std::vector<std::uint32_t>, 8> triangles;
    std::array<std::vector<BodyTurns>, 8> bodies;
    bool helps = false;
};

/// Places are chosen by chance: ways between middles of cells would meet edges of faces where these are made of round
/// numbers.
void WindingCells::halve(Halved& out, const Cell& cell, std::span<const std::uint32_t> triangles,
                         std::span<const BodyTurns> bodies) const {
    std::size_t sum = 0, fullest = 0;
    for (unsigned k = 0; k < 8; ++k) {
        Cell& child = out.cells[k];
        child.size = cell.size / 2;
        child.lo = cell.lo + Vec3d{double(k & 1), double(k >> 1 & 1), double(k >> 2)} * child.size;
        child.place = child.lo;
        base::Random random(base::mix(base::mix(base::mix(seed ^ std::bit_cast<std::uint64_t>(child.lo.x)) ^
                                                std::bit_cast<std::uint64_t>(child.lo.y)) ^
                                      std::bit_cast<std::uint64_t>(child.lo.z)));
        for (std::size_t axis = 0; axis < 3; ++axis)
            child.place[axis] += random.uniform(0.35, 0.65) * child.size;
        child.turns = cell.turns;
        bool holes = false;
        for (std::size_t begin = 0, end, body = 0; begin < triangles.size(); begin = end, ++body) {
            const std::size_t before = out.triangles[k].size();
            for (end = begin; end < triangles.size() && m_topology.bodies[triangles[end]] == bodies[body].body; ++end)
                if (meets(triangles[end], child)) {
                    out.triangles[k].push_back(triangles[end]);
                    child.onTop = std::max(child.onTop, onTop(triangles[end]));
                }
            const int turns =
                bodies[body].turns + turnsBetween(triangles.subspan(begin, end - begin), child.place, cell.place);
            if (out.triangles[k].size() > before) {
                out.bodies[k].push_back({bodies[body].body, turns});
                holes |= m_holes[bodies[body].body] != 0;
            } else
                child.turns += turns;
        }
        child.solid = child.turns > 0 && !holes;
        sum += out.triangles[k].size();
        fullest = std::max(fullest, out.triangles[k].size());
    }
    out.helps = 10 * fullest <= 9 * triangles.size() || sum <= 2 * triangles.size();
}

/// Level by level, as long as there is room: first where cells are largest. What no cut takes apart, as faces on top of
/// each other, stays together.
void WindingCells::halveAll() {
    const auto n = static_cast<double>(m_triangles.size());
    const double most = std::max(ofMany * n, std::min(ofFew * n, many));
    struct Level {
        std::vector<std::uint32_t> triangles, firstBody{0}; ///< the latter of each cell, and the end
        std::vector<BodyTurns> bodies;
    } current, next;
    current.triangles = std::move(m_triangles);
    m_triangles.clear();
    for (const std::uint32_t t : current.triangles)
        if (const std::uint32_t body = m_topology.bodies[t];
            current.bodies.empty() || current.bodies.back().body != body)
            current.bodies.push_back({body, 0});
    current.firstBody.push_back(static_cast<std::uint32_t>(current.bodies.size()));
    for (std::size_t begin = 0, level = 0; begin < m_cells.size(); ++level) {
        const std::size_t end = m_cells.size();
        const auto bodiesOf = [&](std::size_t i) {
            return std::span<const BodyTurns>(current.bodies)
                .subspan(current.firstBody[i], current.firstBody[i + 1] - current.firstBody[i]);
        };
        std::vector<std::unique_ptr<Halved>> halved(end - begin); // most cells of the last levels are not
        base::parallelFor(end - begin, 16, [&](std::size_t i) {
            const Cell& cell = m_cells[begin + i];
            const std::size_t count = cell.end - cell.first;
            if (level < mostLevels && count > fewFaces && !cell.solid && cell.size / 2 >= leastCell * cell.onTop)
                halve(*(halved[i] = std::make_unique<Halved>()), cell,
                      std::span(current.triangles).subspan(cell.first, count), bodiesOf(i));
        });
        next = {};
        for (std::size_t i = 0; i < halved.size(); ++i) {
            Cell& cell = m_cells[begin + i]; // until children are added
            const auto room =
                static_cast<double>(m_triangles.size() + next.triangles.size() + current.triangles.size() - cell.first);
            if (!halved[i] || !halved[i]->helps || room > most) {
                const auto first = static_cast<std::uint32_t>(m_triangles.size());
                m_triangles.insert(m_triangles.end(), current.triangles.begin() + cell.first,
                                   current.triangles.begin() + cell.end);
                cell.first = first, cell.end = static_cast<std::uint32_t>(m_triangles.size());
                for (const BodyTurns& each : bodiesOf(i))
                    cell.turns += each.turns;
                continue;
            }
            cell.children = static_cast<std::uint32_t>(m_cells.size());
            for (unsigned k = 0; k < 8; ++k) {
                Cell child = halved[i]->cells[k];
                const auto& held = halved[i]->triangles[k];
                child.first = static_cast<std::uint32_t>(next.triangles.size());
                next.triangles.insert(next.triangles.end(), held.begin(), held.end());
                child.end = static_cast<std::uint32_t>(next.triangles.size());
                next.bodies.insert(next.bodies.end(), halved[i]->bodies[k].begin(), halved[i]->bodies[k].end());
                next.firstBody.push_back(static_cast<std::uint32_t>(next.bodies.size()));
                m_cells.push_back(child);
            }
            halved[i].reset();
        }
        std::swap(current, next);
        begin = end;
    }
}

std::uint32_t WindingCells::cellAt(const Vec3d& place) const {
    std::uint32_t at = 0;
    while (m_cells[at].children != 0) {
        const Vec3d middle = m_cells[at].lo + Vec3d{1, 1, 1} * (m_cells[at].size / 2);
        at = m_cells[at].children + (place.x >= middle.x ? 1u : 0u) + (place.y >= middle.y ? 2u : 0u) +
             (place.z >= middle.z ? 4u : 0u);
    }
    return at;
}

/// Whether a line along the axis through the place crosses the triangle. What runs through an edge belongs to one side
/// of it alone: sides are compared from their lower place on, so that both triangles reckon the same.
bool WindingCells::isOver(const Vec3d& place, std::uint32_t triangle, std::size_t axis) const {
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

/// By how much the number at `from` is above that at `to`.
int WindingCells::turnsBetween(std::span<const std::uint32_t> triangles, const Vec3d& from, const Vec3d& to) const {
    int out = 0;
    for (const std::uint32_t t : triangles) {
        const Vec3d &n = m_topology.normals[t], a = corner(t, 0);
        const double before = dot(n, from - a), behind = dot(n, to - a);
        if ((before > 0) != (behind > 0) &&
            isOver(from + (to - from) * (before / (before - behind)), t, longestAxis(n)))
            out += behind > 0 ? 1 : -1;
    }
    return out;
}

WindingCells::Turns WindingCells::turnsAround(const Vec3d& place, std::uint32_t triangle) const {
    const Cell& cell = m_cells[cellAt(place)];
    const auto inIt = std::span(m_triangles).subspan(cell.first, cell.end - cell.first);
    const Vec3d away = m_topology.normals[triangle] * (2 * cell.onTop);
    return {cell.turns + turnsBetween(inIt, place + away, cell.place),
            cell.turns + turnsBetween(inIt, place - away, cell.place)};
}

bool WindingCells::isInside(const Vec3d& place, std::uint32_t triangle) const {
    if (m_cells[cellAt(place)].solid)
        return true;
    const auto [outside, within] = turnsAround(place, triangle);
    return outside >= 1 && within >= 1;
}

std::vector<std::uint32_t> WindingCells::bodiesAround(const Vec3d& place, std::uint32_t own) const {
    std::vector<std::uint32_t> open{0}, met;
    while (!open.empty()) {
        const std::uint32_t at = open.back();
        const Cell& cell = m_cells[at];
        open.pop_back();
        const bool past = cell.lo.x + cell.size < place.x;
        if (past || !(cell.lo.y <= place.y && place.y < cell.lo.y + cell.size) ||
            !(cell.lo.z <= place.z && place.z < cell.lo.z + cell.size))
            continue;
        for (std::uint32_t k = 0; cell.children != 0 && k < 8; ++k)
            open.push_back(cell.children + k);
        for (std::uint32_t i = cell.first; cell.children == 0 && i < cell.end; ++i) {
            const std::uint32_t t = m_triangles[i];
            const Vec3d& n = m_topology.normals[t];
            if (m_topology.bodies[t] != own && isOver(place, t, 0) && dot(corner(t, 0) - place, n) / n.x > 0)
                met.push_back(t);
        }
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    std::stable_sort(met.begin(), met.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return m_topology.bodies[a] < m_topology.bodies[b]; });
    std::vector<std::uint32_t> out;
    for (std::size_t begin = 0, upTo; begin < met.size(); begin = upTo) {
        const std::uint32_t body = m_topology.bodies[met[begin]];
        int turns = 0;
        for (upTo = begin; upTo < met.size() && m_topology.bodies[met[upTo]] == body; ++upTo)
            turns += m_topology.normals[met[upTo]].x > 0 ? 1 : -1;
        if (turns > 0)
            out.push_back(body);
    }
    return out;
}

} // namespace mesh
