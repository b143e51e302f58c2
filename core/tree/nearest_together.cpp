// The walk for many positions, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tree/nearest_together.cpp"
#include "core/tree/nearest_together.h"
#include "core/base/instruction_sets.h"

#include "core/tree/nearest_order.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tree {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using base::Box3f;
using surfel::BoundsLanes;
using surfel::SurfelBlock;

constexpr hn::CappedTag<float, NearestLanes::lanes> d;
constexpr hn::RebindToSigned<decltype(d)> di;
using V = hn::Vec<decltype(d)>;
using VI = hn::Vec<decltype(di)>;
constexpr float largest = std::numeric_limits<float>::max();

HWY_INLINE std::size_t step() {
    return hn::Lanes(d);
}

/// As every distance here is taken: differences, squares summed in this order. Rounding is monotone, so that distances
/// to boxes bound those to what is inside without any slack.
HWY_INLINE V lengthSq(V x, V y, V z) {
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

class Walk {
  public:
    Walk(NearestLanes& scratch, std::size_t k, const Box3f& box) : m_s(scratch), m_k(k), m_box(box) {
        m_s.rows = 0;
        for (std::size_t j = 0; j < k; ++j)
            std::fill_n(m_s.best[j], NearestLanes::lanes, largest);
    }

    /// False where too much is met.
    bool visit(const Node& node, std::uint32_t first) {
        return nearestFirst(node, node.childCount, [&](int i) {
            const std::uint32_t number = first + node.firstBlock[i];
            if (node.level > 1)
                return visit(*node.nodes[static_cast<std::size_t>(i)], number);
            const SurfelBlock& block = *node.blocks[static_cast<std::size_t>(i)];
            return nearestFirst(block.boundsLanes(), block.clusterCount(),
                                [&](int cluster) { return meet(block, number, cluster); });
        });
    }

    /// Lists of each place what is as near as its k-th.
    void list() {
        std::fill(std::begin(m_s.count), std::end(m_s.count), std::size_t(0));
        for (std::size_t r = 0; r < m_s.rows; ++r)
            for (unsigned left = nearOnes(r); left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                const std::size_t at = m_s.count[lane]++;
                if (at < NearestLanes::mostListed)
                    m_s.listed[lane][at] = m_s.row[r][lane], m_s.from[lane][at] = static_cast<std::uint32_t>(r);
            }
    }

  private:
    /// Lanes of a row that are near enough for their places.
    HWY_INLINE unsigned nearOnes(std::size_t r) const {
        unsigned out = 0;
        for (std::size_t v = 0; v < NearestLanes::lanes; v += step()) {
            const auto near = hn::Le(hn::Load(d, m_s.row[r] + v), hn::Load(d, m_s.best[m_k - 1] + v));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, near, bits);
            out |= (bits[0] | static_cast<unsigned>(bits[1]) << 8) << v;
        }
        return out;
    }

    /// Is any place so near to a box that what is inside may be among its nearest?
    HWY_INLINE bool mayHold(const BoundsLanes& of, int lane) const {
        const V zero = hn::Zero(d);
        const auto gap = [&](float lo, float hi, std::size_t axis, std::size_t v) {
            const V x = hn::Load(d, m_s.place[axis] + v);
            return hn::Max(hn::Max(hn::Sub(hn::Set(d, lo), x), hn::Sub(x, hn::Set(d, hi))), zero);
        };
        for (std::size_t v = 0; v < NearestLanes::lanes; v += step()) {
            const V sq = lengthSq(gap(of.loX[lane], of.hiX[lane], 0, v), gap(of.loY[lane], of.hiY[lane], 1, v),
                                  gap(of.loZ[lane], of.hiZ[lane], 2, v));
            if (!hn::AllFalse(d, hn::Le(sq, hn::Load(d, m_s.best[m_k - 1] + v))))
                return true;
        }
        return false;
    }

    template <class Fn>
    HWY_INLINE bool nearestFirst(const BoundsLanes& of, int count, const Fn& fn) {
        float distance[fanOut];
        surfel::detail::distancesSq(of, m_box.lo, m_box.hi).store(distance);
        int order[fanOut];
        nearestFirstOrder(distance, count, order);
        for (int i = 0; i < count && distance[order[i]] <= m_most; ++i)
            if (mayHold(of, order[i]) && !fn(order[i]))
                return false;
        return true;
    }

    HWY_INLINE bool meet(const SurfelBlock& block, std::uint32_t number, int cluster) {
        constexpr std::size_t size = surfel::clusterSize;
        if (m_s.rows + size > NearestLanes::mostRows && !narrow())
            return false;
        const float *x = block.channel(cluster, surfel::X), *y = block.channel(cluster, surfel::Y),
                    *z = block.channel(cluster, surfel::Z);
        const int first = cluster * surfel::clusterSize, end = std::min(first + surfel::clusterSize, block.size());
        bool any = false;
        for (int slot = first; slot < end; ++slot, ++x, ++y, ++z)
            any |= meetOne(hn::Set(d, *x), hn::Set(d, *y), hn::Set(d, *z), {&block, number, slot});
        if (any)
            measureMost();
        return true;
    }

    HWY_INLINE bool meetOne(V x, V y, V z, const NearestLanes::Met& met) {
        float* const row = m_s.row[m_s.rows];
        bool any = false;
        for (std::size_t v = 0; v < NearestLanes::lanes; v += step()) {
            const V sq = lengthSq(hn::Sub(x, hn::Load(d, m_s.place[0] + v)), hn::Sub(y, hn::Load(d, m_s.place[1] + v)),
                                  hn::Sub(z, hn::Load(d, m_s.place[2] + v)));
            hn::Store(sq, d, row + v);
            if (hn::AllFalse(d, hn::Le(sq, hn::Load(d, m_s.best[m_k - 1] + v))))
                continue;
            any = true;
            // From the far end, where most stop half way: b'_j = max(b_(j-1), min(b_j, x)).
            std::size_t j = m_k - 1;
            const auto takeDownTo = [&](std::size_t stop) {
                V own = hn::Load(d, m_s.best[j] + v);
                for (; j > stop; --j) {
                    const V before = hn::Load(d, m_s.best[j - 1] + v);
                    hn::Store(hn::Max(before, hn::Min(own, sq)), d, m_s.best[j] + v);
                    own = before;
                }
            };
            takeDownTo(m_k / 2);
            if (j > 0 && hn::AllFalse(d, hn::Lt(sq, hn::Load(d, m_s.best[j - 1] + v)))) {
                hn::Store(hn::Min(hn::Load(d, m_s.best[j] + v), sq), d, m_s.best[j] + v);
                continue;
            }
            takeDownTo(0);
            hn::Store(hn::Min(hn::Load(d, m_s.best[0] + v), sq), d, m_s.best[0] + v);
        }
        if (any)
            m_s.met[m_s.rows++] = met;
        return any;
    }

    HWY_INLINE void measureMost() {
        V most = hn::Load(d, m_s.best[m_k - 1]);
        for (std::size_t v = step(); v < NearestLanes::lanes; v += step())
            most = hn::Max(most, hn::Load(d, m_s.best[m_k - 1] + v));
        m_most = hn::GetLane(hn::MaxOfLanes(d, most));
    }

    /// Drops rows that have got too far. False where too many are left.
    bool narrow() {
        std::size_t kept = 0;
        for (std::size_t r = 0; r < m_s.rows; ++r)
            if (nearOnes(r) != 0) {
                if (kept != r)
                    std::copy_n(m_s.row[r], NearestLanes::lanes, m_s.row[kept]), m_s.met[kept] = m_s.met[r];
                ++kept;
            }
        m_s.rows = kept;
        return kept <= NearestLanes::mostRows / 2;
    }

    NearestLanes& m_s;
    std::size_t m_k;
    Box3f m_box;
    float m_most = largest; ///< of the k-th distances
};

bool walkTogether(const Node& root, std::size_t k, const Box3f& box, NearestLanes& scratch) {
    Walk walk(scratch, k, box);
    if (!walk.visit(root, 0))
        return false;
    walk.list();
    return true;
}

/// How many of a list are smaller than each of them, and whether no two are equal. Room behind the list counts as
/// infinitely far.
bool rankList(NearestLanes& scratch, std::size_t lane) {
    const std::size_t count = scratch.count[lane];
    float* const list = scratch.listed[lane];
    for (std::size_t i = count; i % step() != 0; ++i)
        list[i] = std::numeric_limits<float>::infinity();
    for (std::size_t v = 0; v < count; v += step()) {
        const V mine = hn::Load(d, list + v);
        VI rank = hn::Zero(di);
        for (std::size_t j = 0; j < count; ++j)
            rank = hn::Sub(rank, hn::VecFromMask(di, hn::RebindMask(di, hn::Lt(hn::Set(d, list[j]), mine))));
        hn::Store(rank, di, scratch.rank + v);
    }
    std::size_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += static_cast<std::size_t>(scratch.rank[i]);
    return 2 * sum == count * (count - 1);
}

} // namespace HWY_NAMESPACE
} // namespace tree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tree {

HWY_EXPORT(walkTogether);
HWY_EXPORT(rankList);

/// Ties go by block and slot.
static bool closer(const Neighbour& a, const Neighbour& b) {
    if (a.distanceSq != b.distanceSq)
        return a.distanceSq < b.distanceSq;
    return a.blockNumber != b.blockNumber ? a.blockNumber < b.blockNumber : a.slot < b.slot;
}

void NearestTogether::answer(std::size_t lane, std::vector<Neighbour>& out) {
    const std::size_t count = m_lanes->count[lane], wanted = std::min(m_k, m_tree.size());
    assert(count >= wanted && count <= NearestLanes::mostListed);
    const auto listed = [&](std::size_t i) {
        const NearestLanes::Met& met = m_lanes->met[m_lanes->from[lane][i]];
        return Neighbour{met.block, met.number, met.slot, m_lanes->listed[lane][i]};
    };
    out.resize(count);
    const bool distinct = HWY_DYNAMIC_DISPATCH(rankList)(*m_lanes, lane);
    for (std::size_t i = 0; i < count; ++i)
        out[distinct ? static_cast<std::size_t>(m_lanes->rank[i]) : i] = listed(i);
    if (!distinct)
        std::sort(out.begin(), out.end(), closer);
    out.resize(wanted);
}

void NearestTogether::at(std::span<const base::Vec3f> x, std::size_t first) {
    assert(first + x.size() <= most);
    base::Box3f box;
    for (const base::Vec3f& each : x)
        box.extend(each);
    if (x.size() > 1 && m_k > 0 && m_k <= NearestLanes::mostAsked && m_tree.root()) {
        for (std::size_t lane = 0; lane < NearestLanes::lanes; ++lane)
            for (std::size_t axis = 0; axis < 3; ++axis)
                m_lanes->place[axis][lane] = x[std::min(lane, x.size() - 1)][axis];
        if (HWY_DYNAMIC_DISPATCH(walkTogether)(*m_tree.root(), m_k, box, *m_lanes)) {
            const std::size_t wanted = std::min(m_k, m_tree.size());
            for (std::size_t i = 0; i < x.size(); ++i)
                if (m_lanes->count[i] < wanted || m_lanes->count[i] > NearestLanes::mostListed)
                    m_tree.nearest(x[i], m_k, m_found[first + i]);
                else
                    answer(i, m_found[first + i]);
            return;
        }
        at(x.first(x.size() / 2), first);
        return at(x.subspan(x.size() / 2), first + x.size() / 2);
    }
    for (std::size_t i = 0; i < x.size(); ++i)
        m_tree.nearest(x[i], m_k, m_found[first + i]);
}

} // namespace tree
#endif
