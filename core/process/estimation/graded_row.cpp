// Compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/process/estimation/graded_row.cpp"
#include "core/process/estimation/graded_row.h"
#include "core/base/instruction_sets.h"

#include <limits>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace process {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, GradedRow::lanes> d;
using V = hn::Vec<decltype(d)>;

/// Lanes that hold no neighbour stand lower than any value.
void judgeInLanes(GradedRow& row, std::size_t count, std::size_t fields, float slope) {
    const V px = hn::Set(d, row.position.x), py = hn::Set(d, row.position.y), pz = hn::Set(d, row.position.z);
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const V dx = hn::Sub(px, hn::Load(d, row.x + k)), dy = hn::Sub(py, hn::Load(d, row.y + k)),
                dz = hn::Sub(pz, hn::Load(d, row.z + k));
        const V square = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
        hn::Store(hn::Mul(hn::Set(d, slope), hn::Sqrt(square)), d, row.drop + k);
    }
    const V none = hn::Set(d, -std::numeric_limits<float>::infinity());
    for (std::size_t f = 0; f < fields; ++f) {
        const float* const value = row.value[f];
        V most = hn::Set(d, row.own[f]);
        for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
            const V there = hn::Sub(hn::Load(d, value + k), hn::Load(d, row.drop + k));
            most = hn::Max(most, hn::IfThenElse(hn::FirstN(d, count - k), there, none));
        }
        most = hn::MaxOfLanes(d, most);
        std::uint32_t below = 0;
        for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
            const auto low = hn::Lt(hn::Load(d, value + k), hn::Sub(most, hn::Load(d, row.drop + k)));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, hn::And(low, hn::FirstN(d, count - k)), bits);
            below |= (bits[0] | static_cast<std::uint32_t>(bits[1]) << 8) << k;
        }
        row.wanted[f] = hn::GetLane(most);
        row.below[f] = below;
    }
}

} // namespace HWY_NAMESPACE
} // namespace process
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace process {

HWY_EXPORT(judgeInLanes);

void judgeRow(GradedRow& row, std::size_t count, std::size_t fields, float slope) {
    HWY_DYNAMIC_DISPATCH(judgeInLanes)(row, count, fields, slope);
}

} // namespace process
#endif
