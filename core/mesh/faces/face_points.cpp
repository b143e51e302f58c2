#include "core/mesh/faces/face_points.h"

#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

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
constexpr int groups = 27;

struct Candidate {
    Vec3f position;
    FacePoint point;
    /// To the nearest point taken when that was last asked. It only shrinks: below r the candidate need not be asked.
    float nearest = std::numeric_limits<float>::infinity();
};

/// Areas added up, for choosing triangles by area.
std::vector<double> cumulated(const std::vector<double>& areas) {
    std::vector<double> out(areas.size());
    std::inclusive_scan(areas.begin(), areas.end(), out.begin());
    return out;
}

/// The i-th of n points that are uniform by area: one in each of n equal shares of it (stratified).
FacePoint drawn(const std::vector<double>& sums, std::size_t i, std::size_t n) {
    base::Random random(base::mix(seed ^ i));
    const double share = sums.back() / static_cast<double>(n);
    const double at = (static_cast<double>(i) + random.uniform()) * share;
    std::size_t t = static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin());
    while (t >= sums.size() || (t > 0 && sums[t] == sums[t - 1])) // rounding, triangles without area
        --t;
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1)
        u = 1 - u, v = 1 - v;
    return {static_cast<std::uint32_t>(t), static_cast<float>(u), static_cast<float>(v)};
}

class DartThrower {
  public:
    DartThrower(const FaceTopology& topology, std::span<const Vec3f> positions, std::size_t count,
                const InnerPlaces* inside)
        : m_topology(topology), m_positions(positions), m_inside(inside), m_count(count),
          m_side(
              static_cast<float>(std::sqrt(firstShare * topology.area * outerShare() / static_cast<double>(count)))) {}

    std::vector<FacePoint> run(const base::Progress& progress) {
        draw();
        progress.step(0.3, "Sampling faces");
        findCells();
        progress.step(0.4, "Sampling faces");
        std::size_t taken = 0;
        double share = 1; // of the first r
        for (bool last = false; !last && taken < m_count; share *= shrinking) {
            last = share <= static_cast<double>(tooClose);
            const double r = std::max(share, static_cast<double>(tooClose)) * static_cast<double>(m_side);
            taken += throwAll(static_cast<float>(r), m_count - taken);
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
    };
    struct Key {
        std::uint64_t cell, rank;
        std::uint32_t index;
        bool operator<(const Key& o) const { return cell != o.cell ? cell < o.cell : rank < o.rank; }
    };

    double outerShare() const { return m_inside ? m_inside->outerShare() : 1; }
    void draw();
    void findCells();
    std::size_t throwAll(float r, std::size_t most);
    std::uint32_t throwInto(std::size_t cell, float r);
    float nearestTaken(std::size_t cell, const Candidate& candidate, float enough) const;
    std::uint64_t keyOf(const Vec3f& p) const;

    const FaceTopology& m_topology;
    std::span<const Vec3f> m_positions;
    const InnerPlaces* m_inside; ///< null: nothing is
    std::size_t m_count;
    float m_side; ///< of a cell: the distance of neighbours in a hexagonal layout of so many points
    std::vector<Candidate> m_candidates;
    std::vector<Cell> m_cells;                      ///< by key
    std::vector<std::uint32_t> m_nearFirst, m_near; ///< occupied cells around each, itself first
    std::vector<std::uint32_t> m_groups[groups];    ///< cells of which no two are neighbours
};

constexpr std::uint64_t axisBits = 21, axisMask = (1u << axisBits) - 1;

/// Cells are numbered modulo 2^21 along each axis: what meets that way is only looked at in vain.
std::uint64_t packed(const std::int64_t (&c)[3]) {
    const auto bits = [&](int k) { return static_cast<std::uint64_t>(c[k]) & axisMask; };
    return bits(0) << 2 * axisBits | bits(1) << axisBits | bits(2);
}

std::uint64_t DartThrower::keyOf(const Vec3f& p) const {
    std::int64_t c[3];
    for (std::size_t k = 0; k < 3; ++k)
        c[k] = static_cast<std::int64_t>(std::floor(static_cast<double>(p[k]) / static_cast<double>(m_side)));
    return packed(c);
}

/// Candidates in the order of their cells, within one in that of their ranks.
void DartThrower::draw() {
    const std::vector<double> sums = cumulated(m_topology.areas);
    const auto all = static_cast<std::size_t>(static_cast<double>(candidatesPerPoint * m_count) / outerShare());
    const auto candidate = [&](std::size_t i) {
        const FacePoint point = drawn(sums, i, all);
        Candidate out;
        out.position = base::cast<float>(placeOf(point, m_topology, m_positions));
        out.point = point;
        return out;
    };
    const auto keyFor = [&](const Candidate& each, std::size_t i) -> Key {
        return {keyOf(each.position), base::mix(i ^ ~seed), static_cast<std::uint32_t>(i)};
    };
    std::vector<Key> keys;
    if (outerShare() < 1) { // only what stays is kept: it may be a small part
        std::vector<std::vector<Key>> parts(base::chunkCount(all, 65536));
        base::parallelChunks(all, 65536, [&](std::size_t begin, std::size_t end, std::size_t part) {
            for (std::size_t i = begin; i < end; ++i)
                if (const Candidate each = candidate(i);
                    !m_inside->has(placeOf(each.point, m_topology, m_positions), each.point.triangle))
                    parts[part].push_back(keyFor(each, i));
        });
        for (const auto& part : parts)
            keys.insert(keys.end(), part.begin(), part.end());
    } else {
        keys.resize(all);
        base::parallelFor(all, 4096, [&](std::size_t i) { keys[i] = keyFor(candidate(i), i); });
    }
    std::sort(keys.begin(), keys.end());
    const std::size_t n = keys.size();
    m_candidates.resize(n);
    base::parallelFor(n, 4096, [&](std::size_t i) { m_candidates[i] = candidate(keys[i].index); });
    for (std::uint32_t i = 0; i < n; ++i) {
        if (m_cells.empty() || m_cells.back().key != keys[i].cell)
            m_cells.push_back({keys[i].cell, i, i, i});
        m_cells.back().end = i + 1;
    }
}

void DartThrower::findCells() {
    std::vector<std::array<std::uint32_t, 28>> around(m_cells.size()); // a count, then cells
    base::parallelFor(m_cells.size(), 1024, [&](std::size_t i) {
        const std::uint64_t key = m_cells[i].key;
        const std::int64_t at[3] = {static_cast<std::int64_t>(key >> 2 * axisBits),
                                    static_cast<std::int64_t>(key >> axisBits & axisMask),
                                    static_cast<std::int64_t>(key & axisMask)};
        around[i][0] = 0;
        for (int k = 0; k < groups; ++k) {
            const std::uint64_t wanted = packed({at[0] + k / 9 - 1, at[1] + k / 3 % 3 - 1, at[2] + k % 3 - 1});
            const auto found = std::lower_bound(m_cells.begin(), m_cells.end(), wanted,
                                                [](const Cell& cell, std::uint64_t value) { return cell.key < value; });
            if (found != m_cells.end() && found->key == wanted)
                around[i][++around[i][0]] = static_cast<std::uint32_t>(found - m_cells.begin());
        }
    });
    m_nearFirst.assign(1, 0);
    for (std::uint32_t i = 0; i < m_cells.size(); ++i) {
        std::swap(around[i][1], *std::find(around[i].begin() + 1, around[i].end(), i)); // what is nearest first
        m_near.insert(m_near.end(), around[i].begin() + 1, around[i].begin() + 1 + around[i][0]);
        m_nearFirst.push_back(static_cast<std::uint32_t>(m_near.size()));
        const std::uint64_t key = m_cells[i].key;
        m_groups[(key >> 2 * axisBits) % 3 * 9 + (key >> axisBits & axisMask) % 3 * 3 + (key & axisMask) % 3].push_back(
            i);
    }
}

/// Distance in the metric of a sheet to the nearest point taken so far: infinity beyond the cells around, 0 where any
/// is nearer than `enough`, which most candidates learn from their own cell.
float DartThrower::nearestTaken(std::size_t cell, const Candidate& candidate, float enough) const {
    const Vec3d& n = m_topology.normals[candidate.point.triangle];
    const Vec3f normal = base::cast<float>(n);
    float best = std::numeric_limits<float>::infinity();
    const float enoughSq = enough * enough;
    for (std::uint32_t e = m_nearFirst[cell]; e < m_nearFirst[cell + 1] && best >= enoughSq; ++e) {
        const Cell& near = m_cells[m_near[e]];
        for (std::uint32_t i = near.first; i < near.taken; ++i) {
            const Vec3f offset = m_candidates[i].position - candidate.position;
            const float height = dot(offset, normal), d = lengthSq(offset) + flatness * height * height;
            if (d < best && dot(n, m_topology.normals[m_candidates[i].point.triangle]) > awayCosine)
                best = d;
        }
    }
    return best < enoughSq ? 0 : std::sqrt(best);
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

std::size_t DartThrower::throwAll(float r, std::size_t most) {
    std::size_t taken = 0;
    for (const auto& group : m_groups) {
        std::vector<std::uint32_t> counts(base::chunkCount(group.size(), 256));
        base::parallelChunks(group.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t i = begin; i < end; ++i)
                counts[chunk] += throwInto(group[i], r);
        });
        taken = std::accumulate(counts.begin(), counts.end(), taken);
        if (taken >= most)
            break;
    }
    return taken;
}

} // namespace

std::vector<FacePoint> spreadPoints(const FaceTopology& topology, std::span<const Vec3f> positions, std::size_t count,
                                    const base::Progress& progress, const InnerPlaces* inside) {
    return DartThrower(topology, positions, count, inside).run(progress);
}

Vec3d placeOf(const FacePoint& point, const FaceTopology& topology, std::span<const Vec3f> positions) {
    const Triangle& t = topology.triangles[point.triangle];
    const Vec3d p = base::cast<double>(positions[t[0]]);
    return p + (base::cast<double>(positions[t[1]]) - p) * static_cast<double>(point.b) +
           (base::cast<double>(positions[t[2]]) - p) * static_cast<double>(point.c);
}

} // namespace mesh
