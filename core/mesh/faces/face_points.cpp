#include "core/mesh/faces/face_points.h"

#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/mesh/faces/border_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

namespace mesh {

namespace {

using base::Vec3d;
using base::Vec3f;

constexpr std::uint64_t seed = 0x706f696e74ULL;
constexpr std::size_t candidatesPerPoint = 6;
constexpr double shrinking = 0.94; ///< of r from round to round
/// The first r squared over the area of a point: so much denser than a hexagonal layout that rounds end when little
/// room is left, at spacings of which 90 % lie within 15 % of their mean.
constexpr double firstShare = 0.98;
/// Of the first r, and the last r: a candidate so near to a point taken is never wanted.
constexpr float tooClose = 0.7f;
constexpr float flatness = 3; ///< weight of heights over the tangent plane
constexpr double awayCosine = -0.5;
constexpr double alikeCosine = 0.94; ///< 20 degrees: patches on top of each other have no edge between them
constexpr float acrossSharp = 0.4f;  ///< of r: how near a point across a sharp edge may be
constexpr int groups = 27;
/// By so much the spacing changes within itself at most: neighbours of candidates beyond that from a power of two are
/// of the same one.
constexpr float spacingsDiffer = 1.25f;

struct Candidate {
    Vec3f position;
    FacePoint point;
    float scale = 1; ///< its spacing over the least one
    /// To the nearest point taken when that was last asked. It only shrinks: below r the candidate need not be asked.
    float nearest = std::numeric_limits<float>::infinity();

    /// Of its cell's side over the least one.
    std::uint32_t level() const { return static_cast<std::uint32_t>(std::ceil(std::log2(scale))); }
};

class DartThrower {
  public:
    DartThrower(const FaceTopology& topology, std::span<const Vec3f> positions, std::size_t count, const Spreading& how)
        : m_topology(topology), m_positions(positions), m_inside(how.inside), m_density(how.density),
          m_patches(how.patches), m_rows(how.rows), m_count(count) {
        if (m_density)
            m_parts = m_density->parts();
        m_draws = m_density ? FaceDraws(m_parts) : FaceDraws(topology);
        m_share = m_density  ? m_draws->outerShare(topology, positions, m_inside)
                  : m_inside ? m_inside->outerShare()
                             : 1;
        const double unit = m_density ? m_density->least() * m_density->least() : 1;
        const double area = m_draws->total() * m_share * unit; // were the spacing the least one everywhere
        m_side = static_cast<float>(std::sqrt(firstShare * area / static_cast<double>(count)));
    }

    std::vector<FacePoint> run(const base::Progress& progress) {
        draw();
        progress.step(0.3, "Sampling faces");
        findCells();
        progress.step(0.4, "Sampling faces");
        std::size_t taken = throwAll(tooClose * m_side, m_count, &DartThrower::takeFirst);
        double share = 1; // of the first r
        for (bool last = false; !last && taken < m_count; share *= shrinking) {
            last = share <= static_cast<double>(tooClose);
            const double r = std::max(share, static_cast<double>(tooClose)) * static_cast<double>(m_side);
            taken += throwAll(static_cast<float>(r), m_count - taken, &DartThrower::throwInto);
            progress.step(0.4 + 0.6 * (1 - share) / (1 - static_cast<double>(tooClose)), "Sampling faces");
        }
        std::vector<FacePoint> out;
        out.reserve(taken);
        for (const Cell& cell : m_cells)
            for (std::uint32_t i = cell.first; i < cell.taken; ++i)
                out.push_back(m_candidates[i].point);
        return out;
    }

  private:
    struct Cell {
        std::uint64_t key;
        std::uint32_t first, taken, end; ///< in m_candidates: first the points taken, then what is still open
        std::uint32_t rows;              ///< those of borders end there, before any is taken
        std::uint32_t level;

        bool isBefore(std::uint32_t otherLevel, std::uint64_t other) const {
            return level != otherLevel ? level < otherLevel : key < other;
        }
    };
    struct Key {
        std::uint64_t cell, rank;
        std::uint32_t index, level;
        float scale;
        bool operator<(const Key& o) const {
            return std::tie(level, cell, rank, index) < std::tie(o.level, o.cell, o.rank, o.index);
        }
    };
    struct Place {
        std::int64_t c[3]; ///< of a cell
    };

    void draw();
    void findCells();
    void addCell(std::uint32_t level, const Place& place, std::vector<std::uint32_t>& out) const;
    std::vector<std::uint32_t> otherLevels(const Cell& cell) const;
    using Take = std::uint32_t (DartThrower::*)(std::size_t cell, float r);
    std::size_t throwAll(float r, std::size_t most, Take take);
    std::uint32_t takeFirst(std::size_t cell, float r);
    std::uint32_t throwInto(std::size_t cell, float r);
    float nearestTaken(std::size_t cell, const Candidate& candidate, float enough) const;
    bool otherPatch(std::uint32_t a, std::uint32_t b) const {
        return !m_patches.empty() && m_patches[a] != m_patches[b];
    }
    Place placeOfCell(const Vec3f& p, std::uint32_t level) const;
    /// Of a spacing over the least one.
    template <class SpacingOf>
    double scaleAt(const SpacingOf& spacing) const {
        return m_density ? std::max(1.0, spacing() / m_density->least()) : 1.0;
    }

    const FaceTopology& m_topology;
    std::span<const Vec3f> m_positions;
    const InnerPlaces* m_inside;       ///< null: nothing is
    const FaceDensity* m_density;      ///< null: all evenly
    std::span<const FacePart> m_parts; ///< of the density
    std::optional<FaceDraws> m_draws;
    double m_share = 1;                       ///< of what is drawn, what is not inside
    std::span<const std::uint32_t> m_patches; ///< of the triangles; empty: one
    bool m_rows;                              ///< along borders
    std::size_t m_count;
    float m_side; ///< of the least cell: the distance of neighbours in a hexagonal layout of so many points
    std::vector<Candidate> m_candidates;
    std::vector<Cell> m_cells;                      ///< by key
    std::vector<std::uint32_t> m_nearFirst, m_near; ///< occupied cells around each, itself first
    std::vector<std::uint32_t> m_groups[groups];    ///< cells of which no two of a level are neighbours; by levels
};

constexpr std::uint64_t axisBits = 21, axisMask = (1u << axisBits) - 1;

/// Cells are numbered modulo 2^21 along each axis: what meets that way is only looked at in vain.
std::uint64_t packed(const std::int64_t (&c)[3]) {
    const auto bits = [&](int k) { return static_cast<std::uint64_t>(c[k]) & axisMask; };
    return bits(0) << 2 * axisBits | bits(1) << axisBits | bits(2);
}

DartThrower::Place DartThrower::placeOfCell(const Vec3f& p, std::uint32_t level) const {
    Place out;
    const double side = std::ldexp(static_cast<double>(m_side), static_cast<int>(level));
    for (std::size_t k = 0; k < 3; ++k)
        out.c[k] = base::cellNumber(static_cast<double>(p[k]) / side);
    return out;
}

/// Candidates in the order of their cells, within one in that of their ranks.
void DartThrower::draw() {
    const auto all = static_cast<std::size_t>(static_cast<double>(candidatesPerPoint * m_count) / m_share);
    std::vector<FacePoint> rows;
    if (m_rows)
        rows = borderRows(m_topology, m_positions, [&](const Vec3d& place, std::uint32_t t) {
            return static_cast<double>(m_side) * scaleAt([&] { return m_density->at(place, t); });
        });
    // The draws, and behind them the rows.
    const auto candidate = [&](std::size_t i, std::optional<float> scale = {}) {
        const FaceDraws::Draw drawn = i < all ? m_draws->at(i, all) : FaceDraws::Draw{rows[i - all], 0};
        Candidate out;
        out.point = drawn.point;
        const Vec3d place = placeOf(out.point, m_topology, m_positions);
        out.position = base::cast<float>(place);
        out.scale = scale ? *scale : static_cast<float>(scaleAt([&] {
            return i < all ? m_density->at(place, m_parts[drawn.part]) : m_density->at(place, out.point.triangle);
        }));
        return out;
    };
    const auto keyFor = [&](const Candidate& each, std::size_t i) -> Key {
        const std::uint32_t level = each.level();
        const std::uint64_t rank = i < all ? base::mix(i ^ ~seed) : 0;
        return {packed(placeOfCell(each.position, level).c), rank, static_cast<std::uint32_t>(i), level, each.scale};
    };
    std::vector<Key> keys;
    if (m_share < 1) { // only what stays is kept: it may be a small part
        std::vector<std::vector<Key>> parts(base::chunkCount(all + rows.size(), 65536));
        base::parallelChunks(all + rows.size(), 65536, [&](std::size_t begin, std::size_t end, std::size_t part) {
            for (std::size_t i = begin; i < end; ++i)
                if (const Candidate each = candidate(i);
                    !m_inside->has(placeOf(each.point, m_topology, m_positions), each.point.triangle))
                    parts[part].push_back(keyFor(each, i));
        });
        for (const auto& part : parts)
            keys.insert(keys.end(), part.begin(), part.end());
    } else {
        keys.resize(all + rows.size());
        base::parallelFor(keys.size(), 4096, [&](std::size_t i) { keys[i] = keyFor(candidate(i), i); });
    }
    std::sort(keys.begin(), keys.end());
    const std::size_t n = keys.size();
    m_candidates.resize(n);
    base::parallelFor(n, 4096, [&](std::size_t i) { m_candidates[i] = candidate(keys[i].index, keys[i].scale); });
    for (std::uint32_t i = 0; i < n; ++i) {
        if (m_cells.empty() || m_cells.back().isBefore(keys[i].level, keys[i].cell))
            m_cells.push_back({keys[i].cell, i, i, i, i, keys[i].level});
        m_cells.back().end = i + 1;
        if (keys[i].index >= all)
            m_cells.back().rows = i + 1;
    }
}

void DartThrower::addCell(std::uint32_t level, const Place& place, std::vector<std::uint32_t>& out) const {
    const std::uint64_t wanted = packed(place.c);
    const auto found = std::lower_bound(m_cells.begin(), m_cells.end(), wanted,
                                        [&](const Cell& cell, std::uint64_t key) { return cell.isBefore(level, key); });
    if (found != m_cells.end() && found->level == level && found->key == wanted)
        out.push_back(static_cast<std::uint32_t>(found - m_cells.begin()));
}

/// Cells twice and half as large that reach into those around it.
std::vector<std::uint32_t> DartThrower::otherLevels(const Cell& cell) const {
    std::vector<std::uint32_t> out;
    float least = std::numeric_limits<float>::infinity(), most = 0;
    for (std::uint32_t i = cell.first; i < cell.end; ++i) {
        least = std::min(least, m_candidates[i].scale);
        most = std::max(most, m_candidates[i].scale);
    }
    const float side = std::ldexp(1.0f, static_cast<int>(cell.level));
    const Place at = placeOfCell(m_candidates[cell.first].position, cell.level);
    const auto add = [&](std::uint32_t level, const Place& lo, std::int64_t wide) {
        for (std::int64_t x = 0; x < wide; ++x)
            for (std::int64_t y = 0; y < wide; ++y)
                for (std::int64_t z = 0; z < wide; ++z)
                    addCell(level, {{lo.c[0] + x, lo.c[1] + y, lo.c[2] + z}}, out);
    };
    const auto scaled = [&](const auto& fn) { return Place{{fn(at.c[0]), fn(at.c[1]), fn(at.c[2])}}; };
    if (cell.level > 0 && least < side / 2 * spacingsDiffer)
        add(cell.level - 1, scaled([](std::int64_t c) { return 2 * (c - 1); }), 6);
    if (most * spacingsDiffer > side)
        add(cell.level + 1, scaled([](std::int64_t c) { return (c - 1) >> 1; }), 2);
    return out;
}

void DartThrower::findCells() {
    std::vector<std::vector<std::uint32_t>> around(m_cells.size());
    base::parallelFor(m_cells.size(), 1024, [&](std::size_t i) {
        const std::uint64_t key = m_cells[i].key;
        const std::int64_t at[3] = {static_cast<std::int64_t>(key >> 2 * axisBits),
                                    static_cast<std::int64_t>(key >> axisBits & axisMask),
                                    static_cast<std::int64_t>(key & axisMask)};
        for (int k = 0; k < groups; ++k)
            addCell(m_cells[i].level, {{at[0] + k / 9 - 1, at[1] + k / 3 % 3 - 1, at[2] + k % 3 - 1}}, around[i]);
        if (m_density) {
            const std::vector<std::uint32_t> others = otherLevels(m_cells[i]);
            around[i].insert(around[i].end(), others.begin(), others.end());
        }
    });
    m_nearFirst.assign(1, 0);
    for (std::uint32_t i = 0; i < m_cells.size(); ++i) {
        std::swap(around[i][0], *std::find(around[i].begin(), around[i].end(), i)); // what is nearest first
        m_near.insert(m_near.end(), around[i].begin(), around[i].end());
        m_nearFirst.push_back(static_cast<std::uint32_t>(m_near.size()));
        const std::uint64_t key = m_cells[i].key;
        m_groups[(key >> 2 * axisBits) % 3 * 9 + (key >> axisBits & axisMask) % 3 * 3 + (key & axisMask) % 3].push_back(
            i);
    }
}

/// Distance in the metric of a sheet, longer across edges, to the nearest point taken so far, over the candidate's
/// scale: infinity beyond the cells around, 0 where any is nearer than `enough`, which most candidates learn from their
/// own cell.
float DartThrower::nearestTaken(std::size_t cell, const Candidate& candidate, float enough) const {
    const Vec3d& n = m_topology.normals[candidate.point.triangle];
    const Vec3f normal = base::cast<float>(n);
    float best = std::numeric_limits<float>::infinity();
    const float enoughSq = enough * candidate.scale * (enough * candidate.scale);
    for (std::uint32_t e = m_nearFirst[cell]; e < m_nearFirst[cell + 1] && best >= enoughSq; ++e) {
        const Cell& near = m_cells[m_near[e]];
        for (std::uint32_t i = near.first; i < near.taken; ++i) {
            const Vec3f offset = m_candidates[i].position - candidate.position;
            const float height = dot(offset, normal);
            const std::uint32_t other = m_candidates[i].point.triangle;
            float d = lengthSq(offset) + flatness * height * height;
            if (d >= best)
                continue;
            const double alike = dot(n, m_topology.normals[other]);
            if (alike < alikeCosine && otherPatch(candidate.point.triangle, other))
                d *= 1 / (acrossSharp * acrossSharp);
            if (d < best && alike > awayCosine)
                best = d;
        }
    }
    return best < enoughSq ? 0 : std::sqrt(best) / candidate.scale;
}

/// Those of borders, but where another border is too near.
std::uint32_t DartThrower::takeFirst(std::size_t index, float r) {
    Cell& cell = m_cells[index];
    for (std::uint32_t i = cell.first; i < cell.rows; ++i) {
        m_candidates[i].nearest = nearestTaken(index, m_candidates[i], r);
        if (m_candidates[i].nearest >= r)
            std::swap(m_candidates[cell.taken++], m_candidates[i]);
    }
    return cell.taken - cell.first;
}

std::uint32_t DartThrower::throwInto(std::size_t index, float r) {
    Cell& cell = m_cells[index];
    const std::uint32_t before = cell.taken, end = cell.end;
    std::uint32_t open = before; // those to be asked again, closed up behind the ones taken
    for (std::uint32_t i = before; i < end; ++i) {
        float& distance = m_candidates[i].nearest;
        if (distance >= r)
            distance = nearestTaken(index, m_candidates[i], tooClose * m_side);
        if (distance >= r) {
            std::swap(m_candidates[cell.taken], m_candidates[i]);
            if (open > cell.taken) // what stood there was open
                std::swap(m_candidates[open], m_candidates[i]);
            ++cell.taken, ++open;
        } else if (distance >= tooClose * m_side)
            std::swap(m_candidates[open++], m_candidates[i]);
    }
    cell.end = open;
    return cell.taken - before;
}

std::size_t DartThrower::throwAll(float r, std::size_t most, Take take) {
    std::size_t taken = 0;
    for (const auto& group : m_groups) {
        const auto levelOf = [&](std::size_t i) { return m_cells[group[i]].level; };
        for (std::size_t from = 0, to; from < group.size(); from = to) {
            for (to = from + 1; to < group.size() && levelOf(to) == levelOf(from);)
                ++to;
            std::vector<std::uint32_t> counts(base::chunkCount(to - from, 256));
            base::parallelChunks(to - from, 256, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                for (std::size_t i = begin; i < end; ++i)
                    counts[chunk] += (this->*take)(group[from + i], r);
            });
            taken = std::accumulate(counts.begin(), counts.end(), taken);
        }
        if (taken >= most)
            break;
    }
    return taken;
}

} // namespace

std::vector<FacePoint> spreadPoints(const FaceTopology& topology, std::span<const Vec3f> positions, std::size_t count,
                                    const base::Progress& progress, const Spreading& how) {
    return DartThrower(topology, positions, count, how).run(progress);
}

} // namespace mesh
