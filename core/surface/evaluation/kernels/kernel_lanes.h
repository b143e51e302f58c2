// Vectors of lanes and what the kernels of this room do with them. Included once per instruction set, from within a
// file that Highway compiles several times, after <hwy/highway.h>.
//
// g++ 12 keeps arrays in memory that are indexed in loops, even short ones: hence plain members and loops unrolled by
// hand.
#if defined(POINTCLAY_KERNEL_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_KERNEL_LANES_H
#undef POINTCLAY_KERNEL_LANES_H
#else
#define POINTCLAY_KERNEL_LANES_H
#endif

#include "core/surfel/surfel_block.h"

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, surfel::clusterSize>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr int lanes = surfel::clusterSize;

HWY_INLINE V constant(float value) {
    return hn::Set(D(), value);
}

HWY_INLINE void accumulate(V& sum, V factor, V value) {
    sum = hn::MulAdd(factor, value, sum);
}

/// Calls fn with the constants 0 to n - 1: arrays of vectors stay in registers where all their indices are constants.
template <std::size_t n, class Fn>
HWY_INLINE void unrolled(const Fn& fn) {
    [&]<std::size_t... k>(std::index_sequence<k...>) {
        (fn(std::integral_constant<std::size_t, k>()), ...);
    }
    (std::make_index_sequence<n>());
}

/// The same over the six pairs k <= l of coordinates.
template <class Fn>
HWY_INLINE void forPairs(const Fn& fn) {
    unrolled<3>([&](auto k) { unrolled<3 - k>([&](auto l) { fn(k, std::integral_constant<std::size_t, k + l>()); }); });
}

/// Three vectors in lanes. No array, for the same reason.
struct V3 {
    V x, y, z;
};

HWY_INLINE V3 load3(const float* from, std::size_t step) {
    const D d;
    return {hn::Load(d, from), hn::Load(d, from + step), hn::Load(d, from + 2 * step)};
}
HWY_INLINE V3 minus(const V3& a, const float* b) {
    return {hn::Sub(a.x, constant(b[0])), hn::Sub(a.y, constant(b[1])), hn::Sub(a.z, constant(b[2]))};
}
HWY_INLINE V dot(const V3& a, const V3& b) {
    return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
HWY_INLINE V dot(const V3& a, const float* b) {
    return dot(a, V3{constant(b[0]), constant(b[1]), constant(b[2])});
}
template <std::size_t k>
HWY_INLINE V at(const V3& a) {
    return k == 0 ? a.x : k == 1 ? a.y : a.z;
}

#if HWY_TARGET == HWY_AVX2
/// For each of the 256 masks of eight lanes the numbers of those set, then zeros.
struct PackedLanes {
    std::uint8_t of[256][8] = {};
    constexpr PackedLanes() {
        for (int mask = 0; mask < 256; ++mask)
            for (int lane = 0, count = 0; lane < 8; ++lane)
                if (mask >> lane & 1)
                    of[mask][count++] = static_cast<std::uint8_t>(lane);
    }
};
static constexpr PackedLanes packedLanes;
#endif

/// Moves the lanes of a mask to the front.
#if HWY_TARGET == HWY_AVX2
/// Highway's own way copies its table to the stack at each call when compiled by g++ 12.
class Packing {
  public:
    HWY_INLINE explicit Packing(M keep) : m_indices(hn::Zero(hn::RebindToSigned<D>())) {
        const hn::RebindToSigned<D> d;
        std::uint8_t bits[8];
        hn::StoreMaskBits(D(), keep, bits);
        m_indices = hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), packedLanes.of[bits[0]]));
    }
    HWY_INLINE V pack(V value) const { return hn::TableLookupLanes(value, hn::IndicesFromVec(D(), m_indices)); }

  private:
    hn::Vec<hn::RebindToSigned<D>> m_indices;
};
#else
class Packing {
  public:
    HWY_INLINE explicit Packing(M keep) : m_keep(keep) {}
    HWY_INLINE V pack(V value) const { return hn::Compress(value, m_keep); }

  private:
    M m_keep;
};
#endif

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
