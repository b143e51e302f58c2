// The search for neighbours, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/process/neighbours/nearest_kernel.cpp"
#include "core/process/neighbours/nearest_kernel.h"
#include "core/base/instruction_sets.h"

#include "core/base/scratch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After the main header.
#include "core/process/neighbours/nearest_walk.h"

HWY_BEFORE_NAMESPACE();
namespace process {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using base::Box3f;
using base::Vec3f;

constexpr hn::CappedTag<float, NearestScratch::widest> d;
constexpr hn::RebindToUnsigned<decltype(d)> du;
using V = hn::Vec<decltype(d)>;
using VU = hn::Vec<decltype(du)>;
constexpr hn::RebindToSigned<decltype(d)> di;
using VI = hn::Vec<decltype(di)>;
/// 16 zeros, then ones: lane i of what is loaded from 15 - j on is 1 where i > j.
constexpr std::int32_t laneSteps[2 * NearestScratch::widest] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                                                1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

HWY_INLINE std::size_t lanes() {
    return hn::Lanes(d);
}

/// As the walk takes it (nearest_walk.h).
HWY_INLINE V lengthSq(V x, V y, V z) {
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

/// A cell's surroundings, gathered.
class Around {
  public:
    Around(const Query& query, std::size_t cell, NearestScratch& scratch)
        : m_query(query), m_cell(cell), m_scratch(scratch) {
        std::fill(std::begin(m_scratch.reach), std::end(m_scratch.reach), infinity);
        for (auto& axis : m_scratch.recent)
            std::fill(std::begin(axis), std::end(axis), 0.0f);
    }

    /// Of the cell's clusters `from` to `to` - 1. False where there is too much of it.
    bool gather(std::size_t from, std::size_t to);
    /// REQUIRES: gathered; positions of the cell in their order.
    void nearest(std::uint32_t self, std::uint32_t* index, float* distanceSq);

  private:
    bool gatherCell(std::size_t cell, const Box3f& box, float mostSq);
    void take(std::size_t cluster, std::uint32_t begin, std::uint32_t end);
    float boundSq(const Vec3f& p, std::size_t cluster) const;
    std::size_t nearClusters(const Vec3f& p, float mostSq);
    std::size_t collect(std::uint32_t self, const Vec3f& p, float mostSq);
    std::size_t narrow(std::size_t found);
    void rankFirst(std::size_t count);
    void remember(std::uint32_t self, const Vec3f& p, float farthestSq);

    const Query& m_query;
    std::size_t m_cell;
    NearestScratch& m_scratch;
    std::size_t m_clusters = 0;
    std::array<float, PointCells::largest / PointCells::clusterSize> m_reachSq; ///< of the cell's own clusters
};

bool Around::gather(std::size_t from, std::size_t to) {
    const PointCells& cells = m_query.cells;
    const std::size_t begin = cells.begin[m_cell], end = cells.begin[m_cell + 1], first = cells.firstCluster[m_cell];
    Box3f box;
    float most = 0;
    for (std::size_t c = from; c < to; ++c) {
        const std::size_t i = begin + c * PointCells::clusterSize;
        const Box3f& own = cells.clusterBoxes[first + c];
        box.extend(own);
        m_reachSq[c] = reachSq(m_query, i, std::min<std::size_t>(i + PointCells::clusterSize, end), own);
        most = std::max(most, m_reachSq[c]);
    }
    m_clusters = 0;
    for (std::uint32_t n = 0; n < cells.nodes.size();) {
        const PointCells::Node& node = cells.nodes[n];
        if (!(gapSq(box, node.box) <= most)) {
            n = node.next;
            continue;
        }
        ++n;
        if (node.cell != PointCells::inner && !gatherCell(node.cell, box, most))
            return false;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t c = m_clusters; c < m_clusters + NearestScratch::widest; ++c)
            m_scratch.lo[axis][c] = infinity, m_scratch.hi[axis][c] = infinity;
    return true;
}

bool Around::gatherCell(std::size_t cell, const Box3f& box, float mostSq) {
    const PointCells& cells = m_query.cells;
    std::uint32_t i = cells.begin[cell];
    const std::uint32_t end = cells.begin[cell + 1];
    for (std::uint32_t cluster = cells.firstCluster[cell]; i < end; ++cluster, i += PointCells::clusterSize) {
        if (!(gapSq(box, cells.clusterBoxes[cluster]) <= mostSq))
            continue;
        if (m_clusters == NearestScratch::mostClusters)
            return false;
        take(cluster, i, std::min(i + PointCells::clusterSize, end));
    }
    return true;
}

/// Missing positions are no numbers, so that no comparison lets them in.
void Around::take(std::size_t cluster, std::uint32_t begin, std::uint32_t end) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const std::size_t at = m_clusters * PointCells::clusterSize;
    std::size_t lane = 0;
    for (std::uint32_t i = begin; i < end; ++i, ++lane) {
        const Vec3f& p = m_query.positions[i];
        m_scratch.x[at + lane] = p.x, m_scratch.y[at + lane] = p.y, m_scratch.z[at + lane] = p.z;
    }
    for (; lane < PointCells::clusterSize; ++lane)
        m_scratch.x[at + lane] = m_scratch.y[at + lane] = m_scratch.z[at + lane] = none;
    const Box3f& box = m_query.cells.clusterBoxes[cluster];
    for (std::size_t axis = 0; axis < 3; ++axis)
        m_scratch.lo[axis][m_clusters] = box.lo[axis], m_scratch.hi[axis][m_clusters] = box.hi[axis];
    m_scratch.first[m_clusters++] = begin;
}

/// No neighbour is farther. Whoever stands at a distance e of a position whose neighbours reach to r has as many within
/// r + e; the slack is for rounding, the last term for squares that vanish.
float Around::boundSq(const Vec3f& p, std::size_t cluster) const {
    V least = hn::Set(d, infinity);
    const V x = hn::Set(d, p.x), y = hn::Set(d, p.y), z = hn::Set(d, p.z);
    for (std::size_t i = 0; i < NearestScratch::recents; i += lanes()) {
        const V away = hn::Sqrt(lengthSq(hn::Sub(x, hn::Load(d, m_scratch.recent[0] + i)),
                                         hn::Sub(y, hn::Load(d, m_scratch.recent[1] + i)),
                                         hn::Sub(z, hn::Load(d, m_scratch.recent[2] + i))));
        least = hn::Min(least, hn::Add(away, hn::Load(d, m_scratch.reach + i)));
    }
    const float reach = hn::GetLane(hn::MinOfLanes(d, least));
    return std::min(m_reachSq[cluster], reach * reach * (1 + 0x1p-16f) + 1e-36f);
}

/// Which of the gathered clusters may hold what is so near, ascending.
std::size_t Around::nearClusters(const Vec3f& p, float mostSq) {
    const V zero = hn::Zero(d), most = hn::Set(d, mostSq);
    const auto gapAlong = [&](std::size_t axis, float at, std::size_t c) {
        const V q = hn::Set(d, at);
        return hn::Max(
            hn::Max(hn::Sub(hn::Load(d, m_scratch.lo[axis] + c), q), hn::Sub(q, hn::Load(d, m_scratch.hi[axis] + c))),
            zero);
    };
    const VU lane = hn::Iota(du, 0);
    std::size_t count = 0;
    for (std::size_t c = 0; c < m_clusters; c += lanes()) {
        const auto near = hn::Le(lengthSq(gapAlong(0, p.x, c), gapAlong(1, p.y, c), gapAlong(2, p.z, c)), most);
        const VU number = hn::Add(hn::Set(du, static_cast<std::uint32_t>(c)), lane);
        hn::StoreU(hn::Compress(number, hn::RebindMask(du, near)), du, m_scratch.near + count);
        count += hn::CountTrue(d, near);
    }
    while (count > 0 && m_scratch.near[count - 1] >= m_clusters)
        --count; // beside an infinite bound even padding is near
    return count;
}

/// All but `self` within the bound, in ascending order.
std::size_t Around::collect(std::uint32_t self, const Vec3f& p, float mostSq) {
    const V x = hn::Set(d, p.x), y = hn::Set(d, p.y), z = hn::Set(d, p.z), most = hn::Set(d, mostSq);
    const VU own = hn::Set(du, self), count = hn::Iota(du, 0); // made anew it would go through memory
    const std::size_t clusters = nearClusters(p, mostSq);
    std::size_t found = 0;
    for (std::size_t n = 0; n < clusters; ++n) {
        const std::size_t cluster = m_scratch.near[n], at = cluster * PointCells::clusterSize;
        for (std::size_t lane = 0; lane < PointCells::clusterSize; lane += lanes()) {
            const V sq = lengthSq(hn::Sub(x, hn::Load(d, m_scratch.x + at + lane)),
                                  hn::Sub(y, hn::Load(d, m_scratch.y + at + lane)),
                                  hn::Sub(z, hn::Load(d, m_scratch.z + at + lane)));
            const VU number = hn::Add(hn::Set(du, m_scratch.first[cluster] + static_cast<std::uint32_t>(lane)), count);
            const auto other = hn::RebindMask(d, hn::Ne(number, own));
            const auto inside = hn::And(hn::Le(sq, most), other);
            hn::StoreU(hn::Compress(sq, inside), d, m_scratch.distanceSq + found);
            hn::StoreU(hn::Compress(number, hn::RebindMask(du, inside)), du, m_scratch.index + found);
            found += hn::CountTrue(d, inside);
        }
    }
    return found;
}

/// Of each of the first `count` found the number of those before it, by distance, then by place. Distances are compared
/// by their bits, whose order is the same, so that one more stands for "or equal".
void Around::rankFirst(std::size_t count) {
    const float* const sq = m_scratch.distanceSq;
    const VI zero = hn::Zero(di), one = hn::Set(di, 1);
    for (std::size_t v = 0; v < count; v += lanes()) {
        const VI mine = hn::BitCast(di, hn::Load(d, sq + v)), upTo = hn::Add(mine, one);
        VI rank = zero;
        const auto add = [&](std::size_t j, VI below) {
            const auto before = hn::Lt(hn::Set(di, std::bit_cast<std::int32_t>(sq[j])), below);
            rank = hn::Sub(rank, hn::VecFromMask(di, before));
        };
        const std::size_t stop = std::min(v + lanes(), count);
        for (std::size_t j = 0; j < v; ++j)
            add(j, upTo);
        for (std::size_t j = v; j < stop; ++j) // 1 for the lanes behind the one of j
            add(j, hn::Add(mine, hn::LoadU(di, laneSteps + (NearestScratch::widest - 1) - (j - v))));
        for (std::size_t j = stop; j < count; ++j)
            add(j, mine);
        hn::Store(rank, di, m_scratch.rank + v);
    }
}

/// Drops, in place, what is farther than the k-th of some; returns how many are left.
std::size_t Around::narrow(std::size_t found) {
    const std::size_t k = m_query.k, enough = 2 * k + 24;
    while (found > enough) {
        rankFirst(enough);
        std::size_t at = 0;
        while (m_scratch.rank[at] != static_cast<std::int32_t>(k - 1))
            ++at;
        const V most = hn::Set(d, m_scratch.distanceSq[at]);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < found; i += lanes()) {
            const V sq = hn::Load(d, m_scratch.distanceSq + i);
            const VU number = hn::Load(du, m_scratch.index + i);
            const auto inside = hn::And(hn::Le(sq, most), hn::FirstN(d, found - i));
            hn::StoreU(hn::Compress(sq, inside), d, m_scratch.distanceSq + kept);
            hn::StoreU(hn::Compress(number, hn::RebindMask(du, inside)), du, m_scratch.index + kept);
            kept += hn::CountTrue(d, inside);
        }
        if (kept == found)
            break; // so many at one distance
        found = kept;
    }
    return found;
}

void Around::remember(std::uint32_t self, const Vec3f& p, float farthestSq) {
    const std::size_t at = self % NearestScratch::recents;
    m_scratch.recent[0][at] = p.x, m_scratch.recent[1][at] = p.y, m_scratch.recent[2][at] = p.z;
    m_scratch.reach[at] = std::sqrt(farthestSq);
}

void Around::nearest(std::uint32_t self, std::uint32_t* index, float* distanceSq) {
    const Vec3f p = m_query.positions[self];
    const std::size_t k = m_query.k, cluster = (self - m_query.cells.begin[m_cell]) / PointCells::clusterSize;
    const std::size_t found = narrow(collect(self, p, boundSq(p, cluster)));
    assert(found >= k);
    rankFirst(found);
    for (std::size_t i = 0; i < found; ++i) { // all of them: a branch would be guessed wrong
        const auto rank = static_cast<std::size_t>(m_scratch.rank[i]);
        m_scratch.sortedIndex[rank] = m_scratch.index[i];
        m_scratch.sortedSq[rank] = m_scratch.distanceSq[i];
    }
    std::copy_n(m_scratch.sortedIndex, k, index);
    std::copy_n(m_scratch.sortedSq, k, distanceSq);
    remember(self, p, distanceSq[k - 1]);
}

void nearestInCell(const PointCells& cells, std::span<const Vec3f> positions, std::size_t cell, NearestScratch& scratch,
                   NearestRows& out) {
    const Query query{cells, positions.data(), positions.size(), out.k};
    Around around(query, cell, scratch);
    const std::size_t clusters = (out.count + PointCells::clusterSize - 1) / PointCells::clusterSize;
    const bool whole = around.gather(0, clusters);
    for (std::size_t c = 0; c < clusters; ++c) {
        const bool together = whole || (clusters > 1 && around.gather(c, c + 1));
        const std::size_t end = std::min(out.count, (c + 1) * PointCells::clusterSize);
        for (std::size_t n = c * PointCells::clusterSize; n < end; ++n) {
            const auto self = static_cast<std::uint32_t>(out.first + n);
            std::uint32_t* const index = out.index.data() + n * query.k;
            float* const distanceSq = out.distanceSq.data() + n * query.k;
            if (together)
                around.nearest(self, index, distanceSq);
            else
                searchOne(query, self, index, distanceSq);
        }
    }
}

void nearestAlone(const PointCells& cells, std::span<const Vec3f> positions, std::uint32_t i, std::size_t k,
                  std::uint32_t* index, float* distanceSq) {
    searchOne({cells, positions.data(), positions.size(), k}, i, index, distanceSq);
}

void nearestAnywhere(const PointCells& cells, std::span<const Vec3f> positions, const Vec3f& x, std::size_t k,
                     std::uint32_t* index, float* distanceSq) {
    searchFrom({cells, positions.data(), positions.size(), k}, x, nobody, index, distanceSq);
}

} // namespace HWY_NAMESPACE
} // namespace process
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace process {

HWY_EXPORT(nearestInCell);
HWY_EXPORT(nearestAlone);
HWY_EXPORT(nearestAnywhere);

void nearestOfCell(const PointCells& cells, std::span<const base::Vec3f> positions, std::size_t cell, std::size_t k,
                   NearestRows& out) {
    assert(k >= 1 && k < positions.size());
    static base::Scratch<NearestScratch> scratches;
    const auto scratch = scratches.take();
    out.cell = cell;
    out.first = cells.begin[cell];
    out.count = cells.size(cell);
    out.k = k;
    out.index.resize(out.count * k);
    out.distanceSq.resize(out.count * k);
    HWY_DYNAMIC_DISPATCH(nearestInCell)(cells, positions, cell, *scratch, out);
}

void nearestOfOne(const PointCells& cells, std::span<const base::Vec3f> positions, std::uint32_t i, std::size_t k,
                  std::uint32_t* index, float* distanceSq) {
    assert(k >= 1 && k < positions.size());
    HWY_DYNAMIC_DISPATCH(nearestAlone)(cells, positions, i, k, index, distanceSq);
}

void nearestFrom(const PointCells& cells, std::span<const base::Vec3f> positions, const base::Vec3f& x, std::size_t k,
                 std::uint32_t* index, float* distanceSq) {
    assert(k >= 1 && k <= positions.size());
    HWY_DYNAMIC_DISPATCH(nearestAnywhere)(cells, positions, x, k, index, distanceSq);
}

} // namespace process
#endif
