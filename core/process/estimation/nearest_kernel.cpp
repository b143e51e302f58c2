// The search for neighbours, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/process/estimation/nearest_kernel.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "core/process/estimation/nearest_kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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
constexpr float infinity = std::numeric_limits<float>::infinity();
/// 16 zeros, then ones: lane i of what is loaded from 15 - j on is 1 where i > j.
constexpr std::int32_t laneSteps[2 * NearestScratch::widest] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                                                1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

HWY_INLINE std::size_t lanes() {
    return hn::Lanes(d);
}

/// As every distance here is taken: float differences, squares summed in this order. Rounding is monotone, so that the
/// distance to a box, or across it, taken in the same way bounds those to its positions without any slack.
HWY_INLINE V lengthSq(V x, V y, V z) {
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}
HWY_INLINE float lengthSq(float x, float y, float z) {
    return x * x + y * y + z * z;
}

HWY_INLINE float gap(float lo, float hi, float otherLo, float otherHi) {
    return std::max(std::max(lo - otherHi, otherLo - hi), 0.0f);
}
HWY_INLINE float gapSq(const Box3f& a, const Box3f& b) {
    return lengthSq(gap(a.lo.x, a.hi.x, b.lo.x, b.hi.x), gap(a.lo.y, a.hi.y, b.lo.y, b.hi.y),
                    gap(a.lo.z, a.hi.z, b.lo.z, b.hi.z));
}
HWY_INLINE float gapSq(const Vec3f& p, const Box3f& b) {
    return gapSq(Box3f{p, p}, b);
}
HWY_INLINE float acrossSq(const Box3f& box) {
    return lengthSq(box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z);
}

struct Query {
    const PointCells& cells;
    const Vec3f* positions;
    std::size_t count, k;
};

/// The box of at least k + 1 consecutive positions that hold [begin, end), behind or before it.
inline float reachSq(const Query& q, std::size_t begin, std::size_t end, const Box3f& own) {
    const std::size_t wanted = q.k + 1;
    if (end - begin >= wanted)
        return acrossSq(own);
    const auto grown = [&](std::size_t from, std::size_t to) {
        Box3f box = own;
        for (std::size_t i = from; i < to; ++i)
            box.extend(q.positions[i]);
        return acrossSq(box);
    };
    float least = infinity;
    if (begin + wanted <= q.count)
        least = std::min(least, grown(end, begin + wanted));
    if (end >= wanted)
        least = std::min(least, grown(end - wanted, begin));
    return least < infinity ? least : grown(0, q.count);
}

/// The sorted list of one search.
class Best {
  public:
    Best(std::size_t k, std::uint32_t* index, float* distanceSq) : m_k(k), m_index(index), m_distanceSq(distanceSq) {}
    bool mayTake(float distanceSq) const { return m_size < m_k || distanceSq <= m_distanceSq[m_k - 1]; }
    void offer(std::uint32_t i, float distanceSq) {
        const auto before = [&](std::size_t at) {
            return m_distanceSq[at] < distanceSq || (m_distanceSq[at] == distanceSq && m_index[at] < i);
        };
        if (m_size == m_k && before(m_k - 1))
            return;
        std::size_t at = m_size < m_k ? m_size++ : m_k - 1;
        for (; at > 0 && !before(at - 1); --at)
            m_index[at] = m_index[at - 1], m_distanceSq[at] = m_distanceSq[at - 1];
        m_index[at] = i;
        m_distanceSq[at] = distanceSq;
    }

  private:
    std::size_t m_k, m_size = 0;
    std::uint32_t* m_index;
    float* m_distanceSq;
};

/// The nearer child first, until what is left is farther than the k-th.
HWY_NOINLINE void searchOne(const Query& q, std::uint32_t self, std::uint32_t* index, float* distanceSq) {
    struct Open {
        float distanceSq;
        std::uint32_t node;
    };
    constexpr std::size_t deepest = 128; // 63 bits of a code, and 32 of a number
    std::array<Open, deepest> stack;
    std::size_t size = 0;
    const Vec3f p = q.positions[self];
    const auto& nodes = q.cells.nodes;
    Best best(q.k, index, distanceSq);
    stack[size++] = {0, 0};
    while (size > 0) {
        const Open open = stack[--size];
        if (!best.mayTake(open.distanceSq))
            continue;
        const PointCells::Node& node = nodes[open.node];
        if (node.cell == PointCells::inner) {
            const std::uint32_t a = open.node + 1, b = nodes[a].next;
            const Open first{gapSq(p, nodes[a].box), a}, second{gapSq(p, nodes[b].box), b};
            assert(size + 2 <= deepest);
            const bool firstIsNearer = first.distanceSq <= second.distanceSq;
            stack[size++] = firstIsNearer ? second : first;
            stack[size++] = firstIsNearer ? first : second;
            continue;
        }
        const std::uint32_t end = q.cells.begin[node.cell + 1];
        std::uint32_t i = q.cells.begin[node.cell];
        for (std::uint32_t cluster = q.cells.firstCluster[node.cell]; i < end; ++cluster) {
            const std::uint32_t stop = std::min(i + PointCells::clusterSize, end);
            if (!best.mayTake(gapSq(p, q.cells.clusterBoxes[cluster]))) {
                i = stop;
                continue;
            }
            for (; i < stop; ++i) {
                const Vec3f& o = q.positions[i];
                const float sq = lengthSq(p.x - o.x, p.y - o.y, p.z - o.z);
                if (i != self && best.mayTake(sq))
                    best.offer(i, sq);
            }
        }
    }
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

} // namespace HWY_NAMESPACE
} // namespace process
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace process {

HWY_EXPORT(nearestInCell);
HWY_EXPORT(nearestAlone);

void nearestOfCell(const PointCells& cells, std::span<const base::Vec3f> positions, std::size_t cell, std::size_t k,
                   NearestRows& out) {
    assert(k >= 1 && k < positions.size());
    thread_local const auto scratch = std::make_unique_for_overwrite<NearestScratch>();
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

} // namespace process
#endif
