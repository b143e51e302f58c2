// Compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/evaluation/kernels/double_kernel.cpp"
#include "core/surface/evaluation/kernels/double_kernel.h"
#include "core/base/instruction_sets.h"

#include "core/surfel/surfel_block.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

unsigned holdingDispatched(const float* cluster, const base::Vec3d& x, double scale) {
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> narrow;
    constexpr std::size_t lanes = surfel::clusterSize;
    unsigned out = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        const auto channel = [&](std::size_t k) {
            return hn::PromoteTo(d, hn::LoadU(narrow, cluster + k * lanes + first));
        };
        const auto square = [&](std::size_t k, double from) {
            const auto q = hn::Sub(channel(k), hn::Set(d, from));
            return hn::Mul(q, q);
        };
        const auto sum = hn::Add(hn::Add(square(0, x.x), square(1, x.y)), square(2, x.z));
        const auto inside = hn::Lt(hn::Sqrt(sum), hn::Mul(hn::Set(d, scale), channel(surfel::Support)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, inside, bits);
        out |= static_cast<unsigned>(bits[0] & ((1u << hn::Lanes(d)) - 1)) << first;
    }
    return out;
}

/// Of `some` terms at once, which fit into registers.
template <std::size_t some, class D>
HWY_INLINE void addProducts(D d, const DoubleFactors& factors, std::size_t count, std::size_t term, std::size_t at,
                            double (*sums)[DoubleFactors::width]) {
    hn::Vec<D> sum[some];
    for (std::size_t t = 0; t < some; ++t)
        sum[t] = hn::Load(d, sums[term + t] + at);
    for (std::size_t i = 0; i < count; ++i) {
        const hn::Vec<D> jet = hn::Load(d, factors.jet[i] + at);
        for (std::size_t t = 0; t < some; ++t)
            sum[t] = hn::Add(sum[t], hn::Mul(jet, hn::Set(d, factors.term[i][term + t])));
    }
    for (std::size_t t = 0; t < some; ++t)
        hn::Store(sum[t], d, sums[term + t] + at);
}

template <class D>
HWY_INLINE void addAll(D d, const DoubleFactors& factors, std::size_t count, std::size_t terms, std::size_t width,
                       double (*sums)[DoubleFactors::width]) {
    for (std::size_t at = 0; at < width; at += hn::Lanes(d)) {
        std::size_t term = 0;
        for (; term + 5 <= terms; term += 5)
            addProducts<5>(d, factors, count, term, at, sums);
        for (; term < terms; ++term)
            addProducts<1>(d, factors, count, term, at, sums);
    }
}

void productDispatched(const DoubleFactors& factors, std::size_t count, std::size_t terms, std::size_t width,
                       double (*sums)[DoubleFactors::width]) {
    if (width <= 4)
        addAll(hn::CappedTag<double, 4>(), factors, count, terms, width, sums);
    else
        addAll(hn::CappedTag<double, 8>(), factors, count, terms, width, sums);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(holdingDispatched);
HWY_EXPORT(productDispatched);

unsigned holdingKernel(const float* cluster, const base::Vec3d& x, double scale) {
    return HWY_DYNAMIC_DISPATCH(holdingDispatched)(cluster, x, scale);
}
void productKernel(const DoubleFactors& factors, std::size_t count, std::size_t terms, std::size_t width,
                   double (*sums)[DoubleFactors::width]) {
    HWY_DYNAMIC_DISPATCH(productDispatched)(factors, count, terms, width, sums);
}

} // namespace surface
#endif
