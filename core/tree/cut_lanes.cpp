// Cuts, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tree/cut_lanes.cpp"
#include "core/tree/cut_lanes.h"
#include "core/base/instruction_sets.h"

#include "core/base/box.h"
#include "core/base/ranked.h"
#include "core/surfel/surfel_block.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tree {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Cuts into at most so many blocks try all three axes; above, three times the work would not show in the queries.
constexpr std::size_t carefulBlocks = 16;
constexpr std::size_t clusterSize = surfel::clusterSize;
constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr hn::CappedTag<float, CutLanes::padding> d;
constexpr hn::RebindToUnsigned<decltype(d)> du;
using V = hn::Vec<decltype(d)>;
using VU = hn::Vec<decltype(du)>;
using M = hn::Mask<decltype(d)>;

HWY_INLINE std::size_t lanes() {
    return hn::Lanes(d);
}

/// What lies in front of a cut: coordinates below the value, and those at it from sources below the limit.
struct Cut {
    std::size_t axis = 0;
    float value = 0;
    std::uint32_t limit = 0;
};

class Cutter {
  public:
    Cutter(CutLanes& lanes, std::vector<std::uint32_t>& sizes)
        : m_axis{lanes.axis(0), lanes.axis(1), lanes.axis(2)}, m_source(lanes.sources()), m_sizes(sizes),
          m_scratch(std::make_unique_for_overwrite<float[]>(4 * (lanes.size() + CutLanes::padding))) {
        for (std::size_t k = 0; k < 3; ++k)
            m_behind[k] = m_scratch.get() + k * (lanes.size() + CutLanes::padding);
        m_values = m_behind[0]; // never at the same time
        m_sourceBehind = reinterpret_cast<std::uint32_t*>(m_scratch.get() + 3 * (lanes.size() + CutLanes::padding));
    }

    void cutBlocks(std::size_t begin, std::size_t end, std::size_t blockCount) {
        if (blockCount == 1) {
            m_sizes.push_back(static_cast<std::uint32_t>(end - begin));
            return cutClusters(begin, end);
        }
        const std::size_t left = blockCount / 2;
        const std::size_t front = (clustersFor(end - begin) * left + blockCount / 2) / blockCount * clusterSize;
        move(begin, end, blockCount <= carefulBlocks ? bestCut(begin, end, front) : longCut(begin, end, front));
        cutBlocks(begin, begin + front, left);
        cutBlocks(begin + front, end, blockCount - left);
    }

  private:
    static std::size_t clustersFor(std::size_t count) { return (count + clusterSize - 1) / clusterSize; }

    /// Within a cluster surfels follow their source.
    void cutClusters(std::size_t begin, std::size_t end) {
        if (end - begin <= clusterSize) {
            std::sort(m_source + begin, m_source + end);
            return;
        }
        const std::size_t front = clustersFor(end - begin) / 2 * clusterSize;
        move(begin, end, longCut(begin, end, front));
        cutClusters(begin, begin + front);
        cutClusters(begin + front, end);
    }

    base::Box3f boxOf(std::size_t begin, std::size_t end) const {
        base::Box3f out;
        for (std::size_t k = 0; k < 3; ++k) {
            V lo = hn::Set(d, infinity), hi = hn::Set(d, -infinity);
            for (std::size_t i = begin; i < end; i += lanes()) {
                const V value = hn::LoadU(d, m_axis[k] + i);
                const M inside = hn::FirstN(d, end - i);
                lo = hn::IfThenElse(inside, hn::Min(lo, value), lo);
                hi = hn::IfThenElse(inside, hn::Max(hi, value), hi);
            }
            out.lo[k] = hn::GetLane(hn::MinOfLanes(d, lo));
            out.hi[k] = hn::GetLane(hn::MaxOfLanes(d, hi));
        }
        return out;
    }

    Cut longCut(std::size_t begin, std::size_t end, std::size_t front) {
        const base::Vec3f s = boxOf(begin, end).size();
        return cutAlong(s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2, begin, end, front);
    }

    /// Along the axis that leaves the smaller boxes. Their size is the sum of the sides: of two cuts of a thin sheet it
    /// prefers the one into compact pieces, where area is blind.
    Cut bestCut(std::size_t begin, std::size_t end, std::size_t front) {
        Cut best;
        float bestCost = infinity;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Cut cut = cutAlong(axis, begin, end, front);
            const float cost = costOf(begin, end, cut);
            if (axis == 0 || cost < bestCost)
                best = cut;
            bestCost = std::min(bestCost, cost); // costs may be beyond numbers
        }
        return best;
    }

    M inFront(const Cut& cut, std::size_t i) const {
        const V value = hn::LoadU(d, m_axis[cut.axis] + i), at = hn::Set(d, cut.value);
        const auto below = hn::Lt(hn::LoadU(du, m_source + i), hn::Set(du, cut.limit));
        return hn::Or(hn::Lt(value, at), hn::And(hn::Eq(value, at), hn::RebindMask(d, below)));
    }

    float costOf(std::size_t begin, std::size_t end, const Cut& cut) const {
        const V most = hn::Set(d, infinity), least = hn::Set(d, -infinity);
        V lo[2][3], hi[2][3];
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t k = 0; k < 3; ++k)
                lo[side][k] = most, hi[side][k] = least;
        for (std::size_t i = begin; i < end; i += lanes()) {
            const M inside = hn::FirstN(d, end - i), front = inFront(cut, i);
            const M first = hn::And(front, inside), second = hn::AndNot(front, inside);
            for (std::size_t k = 0; k < 3; ++k) {
                const V value = hn::LoadU(d, m_axis[k] + i);
                lo[0][k] = hn::Min(lo[0][k], hn::IfThenElse(first, value, most));
                hi[0][k] = hn::Max(hi[0][k], hn::IfThenElse(first, value, least));
                lo[1][k] = hn::Min(lo[1][k], hn::IfThenElse(second, value, most));
                hi[1][k] = hn::Max(hi[1][k], hn::IfThenElse(second, value, least));
            }
        }
        float cost[2];
        for (std::size_t side = 0; side < 2; ++side) {
            float sides[3];
            for (std::size_t k = 0; k < 3; ++k)
                sides[k] = hn::GetLane(hn::MaxOfLanes(d, hi[side][k])) - hn::GetLane(hn::MinOfLanes(d, lo[side][k]));
            cost[side] = sides[0] + sides[1] + sides[2];
        }
        return cost[0] + cost[1];
    }

    /// Leaves `front` places in front.
    Cut cutAlong(std::size_t axis, std::size_t begin, std::size_t end, std::size_t front) {
        const float* const place = m_axis[axis];
        std::copy(place + begin, place + end, m_values);
        Cut out{axis, smallest(end - begin, front), 0};
        const V at = hn::Set(d, out.value);
        std::size_t below = 0, equal = 0;
        for (std::size_t i = begin; i < end; i += lanes()) {
            const V value = hn::LoadU(d, place + i);
            const M inside = hn::FirstN(d, end - i);
            below += hn::CountTrue(d, hn::And(hn::Lt(value, at), inside));
            equal += hn::CountTrue(d, hn::And(hn::Eq(value, at), inside));
        }
        if (below < front)
            out.limit = limitOf(out, begin, end, front - below, equal);
        return out;
    }

    /// The source below which `wanted` of the places at a cut's value stand.
    std::uint32_t limitOf(const Cut& cut, std::size_t begin, std::size_t end, std::size_t wanted, std::size_t equal) {
        std::vector<std::uint32_t> sources;
        sources.reserve(equal);
        for (std::size_t i = begin; i < end; ++i)
            if (m_axis[cut.axis][i] == cut.value)
                sources.push_back(m_source[i]);
        return base::ranked(sources, wanted);
    }

    /// The value with `k` of the first `n` before it in their order.
    float smallest(std::size_t n, std::size_t k) {
        for (int round = 0; n > 2 * CutLanes::padding && round < 64; ++round) {
            const V pivot = hn::Set(d, pivotOf(n));
            std::size_t below = 0, upTo = 0;
            for (std::size_t i = 0; i < n; i += lanes()) {
                const V value = hn::LoadU(d, m_values + i);
                const M inside = hn::FirstN(d, n - i);
                below += hn::CountTrue(d, hn::And(hn::Lt(value, pivot), inside));
                upTo += hn::CountTrue(d, hn::And(hn::Le(value, pivot), inside));
            }
            if (k >= below && k < upTo)
                return hn::GetLane(pivot);
            const bool lower = k < below;
            std::size_t kept = 0;
            for (std::size_t i = 0; i < n; i += lanes()) {
                const V value = hn::LoadU(d, m_values + i);
                const M inside = hn::FirstN(d, n - i);
                const M keep = hn::And(lower ? hn::Lt(value, pivot) : hn::Gt(value, pivot), inside);
                hn::StoreU(hn::Compress(value, keep), d, m_values + kept);
                kept += hn::CountTrue(d, keep);
            }
            k -= lower ? 0 : upTo;
            n = kept;
        }
        std::nth_element(m_values, m_values + k, m_values + n);
        return m_values[k];
    }

    static float middleOf(float a, float b, float c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }
    /// The median of three medians of three.
    float pivotOf(std::size_t n) const {
        const auto at = [&](std::size_t k) { return m_values[k * (n - 1) / 8]; };
        return middleOf(middleOf(at(0), at(3), at(6)), middleOf(at(1), at(4), at(7)), middleOf(at(2), at(5), at(8)));
    }

    /// Puts what is in front of the cut in front.
    void move(std::size_t begin, std::size_t end, const Cut& cut) {
        std::size_t front = begin, behind = 0;
        for (std::size_t i = begin; i < end; i += lanes()) {
            const M inside = hn::FirstN(d, end - i), before = inFront(cut, i);
            const M first = hn::And(before, inside), second = hn::AndNot(before, inside);
            const bool whole = front + lanes() <= end; // else the store would reach into what is not ours
            for (std::size_t k = 0; k < 3; ++k) {
                const V value = hn::LoadU(d, m_axis[k] + i);
                hn::StoreU(hn::Compress(value, second), d, m_behind[k] + behind);
                if (whole)
                    hn::StoreU(hn::Compress(value, first), d, m_axis[k] + front);
                else
                    hn::CompressBlendedStore(value, first, d, m_axis[k] + front);
            }
            const VU source = hn::LoadU(du, m_source + i);
            hn::StoreU(hn::Compress(source, hn::RebindMask(du, second)), du, m_sourceBehind + behind);
            if (whole)
                hn::StoreU(hn::Compress(source, hn::RebindMask(du, first)), du, m_source + front);
            else
                hn::CompressBlendedStore(source, hn::RebindMask(du, first), du, m_source + front);
            front += hn::CountTrue(d, first);
            behind += hn::CountTrue(d, second);
        }
        for (std::size_t k = 0; k < 3; ++k)
            std::copy(m_behind[k], m_behind[k] + behind, m_axis[k] + front);
        std::copy(m_sourceBehind, m_sourceBehind + behind, m_source + front);
    }

    float* m_axis[3];
    std::uint32_t* m_source;
    std::vector<std::uint32_t>& m_sizes;
    std::unique_ptr<float[]> m_scratch;
    float* m_behind[3]; ///< what goes behind a cut, while it moves
    std::uint32_t* m_sourceBehind;
    float* m_values; ///< what quickselect works on
};

void cutDispatched(CutLanes& lanes, std::size_t blockCount, std::vector<std::uint32_t>& sizes) {
    Cutter(lanes, sizes).cutBlocks(0, lanes.size(), blockCount);
}

} // namespace HWY_NAMESPACE
} // namespace tree
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tree {

HWY_EXPORT(cutDispatched);

CutLanes::CutLanes(std::size_t count)
    : m_size(count), m_sources(std::make_unique_for_overwrite<std::uint32_t[]>(count + padding)) {
    for (auto& axis : m_lanes) {
        axis = std::make_unique_for_overwrite<float[]>(count + padding);
        std::fill_n(axis.get() + count, padding, 0.0f);
    }
    std::fill_n(m_sources.get() + count, padding, 0u);
}

std::vector<std::uint32_t> CutLanes::cut(std::size_t blockCount) {
    std::vector<std::uint32_t> sizes;
    sizes.reserve(blockCount);
    HWY_DYNAMIC_DISPATCH(cutDispatched)(*this, blockCount, sizes);
    return sizes;
}

} // namespace tree
#endif
