// Compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/reduce/row_products.cpp"
#include "core/reduce/row_products.h"
#include "core/base/instruction_sets.h"

#include <cstddef>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace reduce {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, siteLanes> d;
using V = hn::Vec<decltype(d)>;
constexpr std::size_t pieces = siteLanes / hn::MaxLanes(d);

/// An entry as eight whole numbers. Of six parts, the last two are its site's, which x takes no notice of.
template <int unknowns>
V partsOf(const FitEntry<unknowns>& entry, std::size_t piece) {
    static_assert(offsetof(FitEntry<unknowns>, part) == 0 && sizeof(entry) >= siteLanes * sizeof(std::int16_t));
    constexpr hn::Rebind<std::int16_t, decltype(d)> halves;
    constexpr hn::RebindToSigned<decltype(d)> wholes;
    const auto* first = reinterpret_cast<const std::int16_t*>(&entry) + piece * hn::Lanes(d);
    return hn::ConvertTo(d, hn::PromoteTo(wholes, hn::LoadU(halves, first)));
}

template <int unknowns>
void addProducts(const FitPiece<unknowns>& piece, const float* x, float* sum) {
    const std::size_t lanes = hn::Lanes(d);
    alignas(64) float along[siteLanes];
    piece.forRows([&](std::size_t row, std::span<const FitEntry<unknowns>> entries) {
        for (std::size_t p = 0; p < pieces; ++p) {
            V total = hn::Zero(d);
            for (const FitEntry<unknowns>& e : entries)
                total = hn::Add(total,
                                hn::Mul(partsOf(e, p), hn::LoadU(d, x + std::size_t(e.site) * siteLanes + p * lanes)));
            hn::Store(total, d, along + p * lanes);
        }
        const float all =
            ((along[0] + along[1]) + (along[2] + along[3])) + ((along[4] + along[5]) + (along[6] + along[7]));
        const V times = hn::Set(d, all * piece.unit[row] * piece.unit[row]);
        for (std::size_t p = 0; p < pieces; ++p)
            for (const FitEntry<unknowns>& e : entries) {
                float* const to = sum + std::size_t(e.site) * siteLanes + p * lanes;
                hn::StoreU(hn::Add(hn::LoadU(d, to), hn::Mul(times, partsOf(e, p))), d, to);
            }
    });
}

void ofBalls(const FitPiece<unknownsOfBalls>& piece, const float* x, float* sum) {
    addProducts(piece, x, sum);
}

void ofEllipsoids(const FitPiece<unknownsOfEllipsoids>& piece, const float* x, float* sum) {
    addProducts(piece, x, sum);
}

} // namespace HWY_NAMESPACE
} // namespace reduce
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace reduce {

HWY_EXPORT(ofBalls);
HWY_EXPORT(ofEllipsoids);

template <int unknowns>
void addRowProducts(const FitPiece<unknowns>& piece, std::span<const float> x, std::span<float> sum) {
    if constexpr (unknowns == unknownsOfBalls)
        HWY_DYNAMIC_DISPATCH(ofBalls)(piece, x.data(), sum.data());
    else
        HWY_DYNAMIC_DISPATCH(ofEllipsoids)(piece, x.data(), sum.data());
}

template void addRowProducts(const FitPiece<unknownsOfBalls>&, std::span<const float>, std::span<float>);
template void addRowProducts(const FitPiece<unknownsOfEllipsoids>&, std::span<const float>, std::span<float>);

} // namespace reduce
#endif
