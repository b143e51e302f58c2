// The look around every touched surfel: who is too close, and where is room. One cell of the grid at a time, whose
// neighbourhood all its surfels share; the eight directions of a surfel lie in lanes.
#include "core/base/parallel_sort.h"
#include "core/process/resampling/resample_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace process {

namespace {

constexpr int directions = 8;
constexpr float diagonal = 0.70710678f;
constexpr float cosines[directions] = {1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal};
constexpr float sines[directions] = {0, diagonal, 1, diagonal, 0, -diagonal, -1, -diagonal};

/// Cells per task.
constexpr std::size_t grain = 64;

/// Four lanes, spelt out because the compiler does not find them in a loop of comparisons.
using Quad = float __attribute__((vector_size(16)));
using QuadMask = int __attribute__((vector_size(16)));

/// Eight places around a surfel, relative to it, and whether something is too near each.
struct Ring {
    Quad x[2], y[2], z[2];
    QuadMask taken[2] = {};

    Ring(const base::Vec3f& n, float distance) {
        const base::Vec3f u = perpendicular(n) * distance, v = cross(n, u);
        for (int h = 0; h < 2; ++h) {
            const float *c = cosines + 4 * h, *s = sines + 4 * h;
            const Quad cosine{c[0], c[1], c[2], c[3]}, sine{s[0], s[1], s[2], s[3]};
            x[h] = u.x * cosine + v.x * sine;
            y[h] = u.y * cosine + v.y * sine;
            z[h] = u.z * cosine + v.z * sine;
        }
    }
    void take(const base::Vec3f& p, float clearSq) {
        for (int h = 0; h < 2; ++h) {
            const Quad dx = p.x - x[h], dy = p.y - y[h], dz = p.z - z[h];
            taken[h] |= dx * dx + dy * dy + dz * dz < clearSq;
        }
    }
    bool free(int k) const { return taken[k / 4][k % 4] == 0; }
    base::Vec3f place(int k) const { return {x[k / 4][k % 4], y[k / 4][k % 4], z[k / 4][k % 4]}; }
};

/// What stands in a cell and around it, in arrays.
struct Around {
    std::vector<float> x, y, z, sq;
    std::vector<std::uint32_t> index;

    void clear() { x.clear(), y.clear(), z.clear(), index.clear(); }
    void add(const PointGrid::Entry& e) {
        x.push_back(e.position.x), y.push_back(e.position.y), z.push_back(e.position.z);
        index.push_back(e.index);
    }
    void measureFrom(const base::Vec3f& p) {
        sq.resize(x.size());
        for (std::size_t k = 0; k < sq.size(); ++k) {
            const float dx = x[k] - p.x, dy = y[k] - p.y, dz = z[k] - p.z;
            sq[k] = dx * dx + dy * dy + dz * dz;
        }
    }
};

struct Scanner {
    const SampleSet& set;
    float closeSq; ///< in units of the targets

    explicit Scanner(const SampleSet& s) : set(s) { closeSq = lookedAt(s.options) * lookedAt(s.options); }

    bool asked(std::uint32_t i) const { return set.is(i, Scan) && !set.is(i, Gone); }

    void look(std::uint32_t i, Around& around, ScanResult& out) const {
        const base::Vec3f p = set.position[i], n = set.normal[i];
        const float target = set.target[i], clearSq = fillClear * fillClear * target * target;
        const float reach = std::max(fillReach, lookedAt(set.options) * unlike) * target, reachSq = reach * reach;
        Ring ring(normalized(n, base::Vec3f{0, 0, 1}), fillDistance * target);
        int alike = 0, others = 0;
        around.measureFrom(p);
        for (std::size_t k = 0; k < around.sq.size(); ++k) {
            const std::uint32_t j = around.index[k];
            if (!(around.sq[k] < reachSq) || j == i)
                continue;
            if (!set.facing.same(n, set.normal[j])) {
                ++others;
                continue;
            }
            ++alike;
            const float mean = set.between(i, j), distanceSq = around.sq[k] / (mean * mean);
            if (distanceSq < closeSq)
                close(i, j, distanceSq, out);
            ring.take(base::Vec3f{around.x[k], around.y[k], around.z[k]} - p, clearSq);
        }
        if (set.free(i) && isStray(alike, others)) {
            out.strays.push_back(i);
            return;
        }
        if (set.is(i, Masked))
            return; // was not moved: what room it has, it had
        for (int k = 0; k < directions; ++k)
            if (ring.free(k))
                out.gaps.push_back({i, static_cast<std::uint32_t>(k), p + ring.place(k)});
    }

    /// Each pair is reported once: by the smaller number, or by the one that is scanned.
    void close(std::uint32_t i, std::uint32_t j, float sq, ScanResult& out) const {
        if ((j < i && set.is(j, Scan)) || (!set.free(i) && !set.free(j)))
            return;
        out.pairs.push_back({sq, std::min(i, j), std::max(i, j)});
    }

    /// The box of all that `look` may ask for, for any of these.
    base::Box3f seenFrom(std::span<const PointGrid::Entry> entries) const {
        base::Box3f box;
        float most = 0;
        for (const PointGrid::Entry& e : entries)
            box.extend(e.position), most = std::max(most, set.target[e.index]);
        return box.inflated(std::max(fillReach, lookedAt(set.options) * unlike) * most);
    }
    void gather(std::span<const std::size_t> cells, const base::Box3f& seen, Around& around) const {
        around.clear();
        for (const std::size_t rank : cells)
            set.grid.forRuns(rank, [&](std::span<const PointGrid::Entry> entries, const base::Box3f* box) {
                if (!box || box->overlaps(seen))
                    for (const PointGrid::Entry& e : entries)
                        if (!set.is(e.index, Gone))
                            around.add(e);
            });
    }
    void scanCells(std::size_t begin, std::size_t end, ScanResult& out) const {
        PointGrid::Walk walk(set.grid, begin);
        std::vector<std::size_t> cells;
        Around around;
        for (std::size_t rank = begin; rank < end; ++rank) {
            const auto members = set.grid.members(rank);
            if (std::none_of(members.begin(), members.end(), [&](const auto& e) { return asked(e.index); }))
                continue;
            cells.clear();
            walk.around(rank, [&](std::size_t near) { cells.push_back(near); });
            set.grid.forRuns(rank, [&](std::span<const PointGrid::Entry> run, const base::Box3f*) {
                gather(cells, seenFrom(run), around);
                for (const PointGrid::Entry& e : run)
                    if (asked(e.index))
                        look(e.index, around, out);
            });
        }
    }
};

template <class T>
void gather(std::vector<T>& all, const std::vector<T>& part) {
    all.insert(all.end(), part.begin(), part.end());
}

} // namespace

ScanResult scan(SampleSet& set) {
    if (std::none_of(set.flags.begin(), set.flags.end(), [](std::uint8_t f) { return (f & Scan) != 0; }))
        return {};
    const Scanner scanner(set);
    std::vector<ScanResult> parts(base::chunkCount(set.grid.cellCount(), grain));
    base::parallelChunks(set.grid.cellCount(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        scanner.scanCells(begin, end, parts[chunk]);
    });
    ScanResult out;
    for (const ScanResult& part : parts)
        gather(out.strays, part.strays), gather(out.pairs, part.pairs), gather(out.gaps, part.gaps);
    std::sort(out.strays.begin(), out.strays.end());
    base::parallelSort(out.pairs, [](const ClosePair& a, const ClosePair& b) {
        return std::tie(a.distanceSq, a.a, a.b) < std::tie(b.distanceSq, b.a, b.b);
    });
    base::parallelSort(out.gaps,
                       [](const Gap& a, const Gap& b) { return std::tie(a.from, a.k) < std::tie(b.from, b.k); });
    for (auto& flag : set.flags)
        flag = static_cast<std::uint8_t>(flag & ~Scan);
    return out;
}

} // namespace process
