// Sums over lanes: kept in memory while there are more clusters, and added up in a fixed order (moments_kernel.cpp).
// Included once per instruction set, from within a file that Highway compiles several times, after <hwy/highway.h>.
#if defined(POINTCLAY_KERNEL_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_KERNEL_ROWS_H
#undef POINTCLAY_KERNEL_ROWS_H
#else
#define POINTCLAY_KERNEL_ROWS_H
#endif

#include "core/surface/evaluation/kernels/kernel_lanes.h"
#include "core/surface/evaluation/moments_float.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

/// Sums in memory, 8 of the 16 lanes: lane i holds that of i and i + 8 together.
template <int order, Outer outer>
struct Rows {
    static constexpr int monomials = monomialCount(outer), sums = sumCount(order, outer), padded = (sums + 7) / 8 * 8;
    static constexpr std::size_t width = lanes / 2;
    HWY_ALIGN float row[padded * width];
    HWY_ALIGN float lower[padded * width]; ///< lanes below 8, where registers hold no more

    /// Takes the lanes from `first` on of one part's sum and adds them to the parts before, unless it is the first.
    HWY_INLINE void put(std::size_t k, std::size_t first, V sum, bool fresh) {
        float* to = row + k * width + first % width;
#if HWY_MAX_BYTES >= 64
        const hn::FixedTag<float, width> d;
        const auto both = hn::Add(hn::LowerHalf(d, sum), hn::UpperHalf(d, sum));
#else
        const D d;
        float* below = lower + k * width + first % width;
        if (first < width) {
            hn::Store(sum, d, below);
            return;
        }
        const auto both = hn::Add(hn::Load(d, below), sum);
#endif
        hn::Store(fresh ? both : hn::Add(hn::Load(d, to), both), d, to);
    }
};

/// Adds up the lanes of 8 sums by halves, always the same adds: i and i + 8 (in Rows), i and i + 4, i and i + 2, the
/// last two.
#if HWY_MAX_BYTES >= 32
HWY_INLINE void reduceEight(const float* rows, float* out) {
    using D8 = hn::FixedTag<float, 8>;
    const D8 d8;
    const hn::Repartition<double, D8> pairs;
    const auto quarter = [&](std::size_t k) { // the lower block of sum k, the upper of sum k + 4
        const auto a = hn::Load(d8, rows + 8 * k), b = hn::Load(d8, rows + 8 * (k + 4));
        return hn::Add(hn::ConcatLowerLower(d8, b, a), hn::ConcatUpperUpper(d8, b, a));
    };
    const auto eighth = [&](auto a, auto b) {
        return hn::Add(hn::InterleaveLower(d8, a, b), hn::InterleaveUpper(d8, a, b));
    };
    const auto ab = hn::BitCast(pairs, eighth(quarter(0), quarter(1)));
    const auto cd = hn::BitCast(pairs, eighth(quarter(2), quarter(3)));
    const auto even = hn::BitCast(d8, hn::InterleaveLower(pairs, ab, cd));
    const auto odd = hn::BitCast(d8, hn::InterleaveUpper(pairs, ab, cd));
    hn::Store(hn::Add(even, odd), d8, out);
}
#else
HWY_INLINE void reduceEight(const float* rows, float* out) {
    for (int k = 0; k < 8; ++k, rows += 8) {
        float r[4];
        for (int i = 0; i < 4; ++i)
            r[i] = rows[i] + rows[i + 4];
        out[k] = (r[0] + r[2]) + (r[1] + r[3]);
    }
}
#endif

template <int order, Outer outer>
HWY_INLINE void reduce(const Rows<order, outer>& rows, float* sums) {
    for (int k = 0; k < rows.padded; k += 8)
        reduceEight(rows.row + k * rows.width, sums + k);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
