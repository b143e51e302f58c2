// The look around every touched surfel: who is too close, and where is room. One cell of the grid at a time, whose
// neighbourhood all its surfels share; the eight directions of a surfel lie in lanes.
#include "core/base/parallel.h"
#include "core/process/resample_set.h"

#include <algorithm>
#include <cmath>

namespace process {

namespace {

constexpr int directions = 8;
constexpr float diagonal = 0.70710678f;
constexpr float cosines[directions] = {1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal};
constexpr float sines[directions] = {0, diagonal, 1, diagonal, 0, -diagonal, -1, -diagonal};

/// Cells per task.
constexpr std::size_t grain = 64;

/// Eight places around a surfel, relative to it, and whether something is too near each.
struct Ring {
    alignas(32) float x[directions], y[directions], z[directions];
    alignas(32) int taken[directions] = {};

    Ring(const base::Vec3f& n, float distance) {
        const base::Vec3f u = perpendicular(n) * distance, v = cross(n, u);
        for (int k = 0; k < directions; ++k) {
            x[k] = u.x * cosines[k] + v.x * sines[k];
            y[k] = u.y * cosines[k] + v.y * sines[k];
            z[k] = u.z * cosines[k] + v.z * sines[k];
        }
    }
    void take(const base::Vec3f& p, float clearSq) {
        for (int k = 0; k < directions; ++k) {
            const float dx = p.x - x[k], dy = p.y - y[k], dz = p.z - z[k];
            taken[k] |= dx * dx + dy * dy + dz * dz < clearSq;
        }
    }
};

struct Scanner {
    const SampleSet& set;
    float closeSq, reachSq, clearSq;

    explicit Scanner(const SampleSet& s) : set(s) {
        closeSq = closeDistance * closeDistance * s.spacing * s.spacing;
        reachSq = fillReach * fillReach * s.spacing * s.spacing;
        clearSq = fillClear * fillClear * s.spacing * s.spacing;
    }

    void look(std::uint32_t i, const std::vector<PointGrid::Entry>& around, ScanResult& out) const {
        const base::Vec3f p = set.position[i], n = set.normal[i];
        // Fully masked surfels were not moved: what room they have, they had.
        const bool fills = !set.is(i, Masked);
        Ring ring(normalized(n, base::Vec3f{0, 0, 1}), fillDistance * set.spacing);
        for (const PointGrid::Entry& e : around) {
            const base::Vec3f d = e.position - p;
            const float sq = lengthSq(d);
            if (!(sq < reachSq) || e.index == i || !set.facing.same(n, set.normal[e.index]))
                continue;
            if (sq < closeSq)
                close(i, e.index, sq, out);
            ring.take(d, clearSq);
        }
        if (!fills)
            return;
        for (int k = 0; k < directions; ++k)
            if (!ring.taken[k])
                out.gaps.push_back(
                    {i, static_cast<std::uint32_t>(k), p + base::Vec3f{ring.x[k], ring.y[k], ring.z[k]}});
    }

    /// Each pair is reported once: by the smaller number, or by the one that is scanned.
    void close(std::uint32_t i, std::uint32_t j, float sq, ScanResult& out) const {
        if ((j < i && set.is(j, Scan)) || (!set.free(i) && !set.free(j)))
            return;
        out.pairs.push_back({sq, std::min(i, j), std::max(i, j)});
    }
};

template <class T>
void gather(std::vector<T>& all, const std::vector<T>& part) {
    all.insert(all.end(), part.begin(), part.end());
}

} // namespace

ScanResult scan(SampleSet& set) {
    const Scanner scanner(set);
    std::vector<ScanResult> parts(base::chunkCount(set.grid.cellCount(), grain));
    base::parallelChunks(set.grid.cellCount(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        std::vector<PointGrid::Entry> around;
        for (std::size_t cell = begin; cell < end; ++cell) {
            const auto members = set.grid.members(cell);
            const auto asked = [&](const PointGrid::Entry& e) {
                return set.is(e.index, Scan) && !set.is(e.index, Gone);
            };
            if (std::none_of(members.begin(), members.end(), asked))
                continue;
            set.grid.neighbourhood(cell, around);
            std::erase_if(around, [&](const PointGrid::Entry& e) { return set.is(e.index, Gone); });
            for (const PointGrid::Entry& e : members)
                if (asked(e))
                    scanner.look(e.index, around, parts[chunk]);
        }
    });
    ScanResult out;
    for (const ScanResult& part : parts)
        gather(out.pairs, part.pairs), gather(out.gaps, part.gaps);
    std::sort(out.pairs.begin(), out.pairs.end(), [](const ClosePair& a, const ClosePair& b) {
        return std::tie(a.distanceSq, a.a, a.b) < std::tie(b.distanceSq, b.a, b.b);
    });
    std::sort(out.gaps.begin(), out.gaps.end(),
              [](const Gap& a, const Gap& b) { return std::tie(a.from, a.k) < std::tie(b.from, b.k); });
    for (auto& flag : set.flags)
        flag = static_cast<std::uint8_t>(flag & ~Scan);
    return out;
}

} // namespace process
