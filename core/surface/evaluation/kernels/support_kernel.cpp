// Which clusters may have weight in a box, 16 at a time, compiled once per instruction set and chosen at run time
// (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/evaluation/kernels/support_kernel.cpp"
#include "core/base/instruction_sets.h"
#include "core/surface/evaluation/candidates.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Per instruction set, after the main header.
#include "core/surface/evaluation/kernels/kernel_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

/// distance(box, bounds) < support for bounds in lanes, by the same operations as the tree's own test.
void supportDispatched(const float* bounds, std::size_t groups, const base::Box3f& box, std::uint16_t* bits) {
    const D d;
    const int width = static_cast<int>(hn::Lanes(d));
    const V lo[3] = {constant(box.lo.x), constant(box.lo.y), constant(box.lo.z)};
    const V hi[3] = {constant(box.hi.x), constant(box.hi.y), constant(box.hi.z)};
    for (std::size_t g = 0; g < groups; ++g, bounds += 7 * lanes) {
        unsigned found = 0;
        for (int first = 0; first < lanes; first += width) {
            V square[3];
            for (int k = 0; k < 3; ++k) {
                const V below = hn::Sub(hn::LoadU(d, bounds + k * lanes + first), hi[k]);
                const V above = hn::Sub(lo[k], hn::LoadU(d, bounds + (3 + k) * lanes + first));
                const V away = hn::Max(hn::Max(below, above), hn::Zero(d));
                square[k] = hn::Mul(away, away);
            }
            const V support = hn::LoadU(d, bounds + 6 * lanes + first);
            const V distanceSq = hn::Add(hn::Add(square[0], square[1]), square[2]);
            std::uint8_t mask[8] = {};
            hn::StoreMaskBits(d, hn::Lt(distanceSq, hn::Mul(support, support)), mask);
            found |= (mask[0] | static_cast<unsigned>(mask[1]) << 8) << first;
        }
        bits[g] = static_cast<std::uint16_t>(found);
    }
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(supportDispatched);

void supportKernel(const float* bounds, std::size_t groups, const base::Box3f& box, std::uint16_t* bits) {
    HWY_DYNAMIC_DISPATCH(supportDispatched)(bounds, groups, box, bits);
}

} // namespace surface
#endif
