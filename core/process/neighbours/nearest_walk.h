// The search for the neighbours of one position, and what it shares with that for many (nearest_kernel.cpp): for the
// files that are compiled once per instruction set.
#if defined(POINTCLAY_NEAREST_WALK_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_NEAREST_WALK_H
#undef POINTCLAY_NEAREST_WALK_H
#else
#define POINTCLAY_NEAREST_WALK_H
#endif

#include "core/process/neighbours/point_cells.h"

#include <array>
#include <cassert>
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace process {
namespace HWY_NAMESPACE {
using base::Box3f;
using base::Vec3f;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// As every distance here is taken: float differences, squares summed in this order. Rounding is monotone, so that the
/// distance to a box, or across it, taken in the same way bounds those to its positions without any slack.
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

/// Number of no position: of a search that leaves none out.
constexpr std::uint32_t nobody = ~std::uint32_t(0);

/// From p, without `self`. The nearer child first, until what is left is farther than the k-th.
HWY_NOINLINE void searchFrom(const Query& q, const Vec3f& p, std::uint32_t self, std::uint32_t* index,
                             float* distanceSq) {
    struct Open {
        float distanceSq;
        std::uint32_t node;
    };
    constexpr std::size_t deepest = 128; // 63 bits of a code, and 32 of a number
    std::array<Open, deepest> stack;
    std::size_t size = 0;
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

inline void searchOne(const Query& q, std::uint32_t self, std::uint32_t* index, float* distanceSq) {
    searchFrom(q, q.positions[self], self, index, distanceSq);
}

} // namespace HWY_NAMESPACE
} // namespace process
HWY_AFTER_NAMESPACE();

#endif
