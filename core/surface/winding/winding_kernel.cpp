// The sum over groups, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/winding/winding_kernel.cpp"
#include "core/surface/winding/winding_kernel.h"
#include "core/base/instruction_sets.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using WindingD = hn::CappedTag<float, WindingGroup::lanes>;
using WindingV = hn::Vec<WindingD>;

/// What is added up, in lanes: more of one target's vectors where these have only four.
template <std::size_t rows>
struct WindingSums {
    alignas(32) float lane[rows][WindingGroup::lanes] = {};

    HWY_INLINE void add(std::size_t row, std::size_t first, WindingV more) {
        const WindingD d;
        hn::Store(hn::Add(hn::Load(d, lane[row] + first), more), d, lane[row] + first);
    }
    double sum(std::size_t row) const {
        double out = 0;
        for (const float each : lane[row])
            out += static_cast<double>(each);
        return out;
    }
};

/// With p from x to a dipole: its term is a . p / |p|^3, softly.
struct WindingTerms {
    WindingV px, py, pz, ax, ay, az, along, square, cube;
    hn::Mask<WindingD> counts, far;

    HWY_INLINE WindingTerms(const WindingGroup& group, std::size_t first, const base::Vec3f& to) {
        const WindingD d;
        px = hn::Add(hn::Load(d, group.x + first), hn::Set(d, to.x));
        py = hn::Add(hn::Load(d, group.y + first), hn::Set(d, to.y));
        pz = hn::Add(hn::Load(d, group.z + first), hn::Set(d, to.z));
        ax = hn::Load(d, group.areaX + first);
        ay = hn::Load(d, group.areaY + first);
        az = hn::Load(d, group.areaZ + first);
        along = hn::MulAdd(ax, px, hn::MulAdd(ay, py, hn::Mul(az, pz)));
        const WindingV distanceSq = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
        far = hn::Gt(distanceSq, hn::Load(d, group.farSq + first));
        square = hn::Add(distanceSq, hn::Load(d, group.softSq + first));
        counts = hn::And(far, hn::Gt(square, hn::Zero(d)));
        cube = hn::Mul(square, hn::Sqrt(square));
    }
};

/// fn(terms, first lane) of all that counts as one, from the topmost group on.
template <class Fn>
HWY_INLINE void forWindingTerms(std::span<const WindingGroup> groups, const base::Vec3d& x, const Fn& fn) {
    constexpr std::size_t deepest = 40; // levels of a tree
    std::array<std::uint32_t, WindingGroup::lanes * deepest> open;
    std::size_t count = 0;
    if (!groups.empty())
        open[count++] = 0;
    while (count > 0)
        for (std::uint32_t at = open[--count]; at != WindingGroup::none;) {
            const WindingGroup& group = groups[at];
            const base::Vec3f to = base::cast<float>(base::cast<double>(group.centre) - x);
            unsigned near = 0;
            for (std::size_t first = 0; first < WindingGroup::lanes; first += hn::Lanes(WindingD())) {
                const WindingTerms terms(group, first, to);
                fn(terms, first);
                std::uint8_t bits[8] = {};
                hn::StoreMaskBits(WindingD(), hn::Not(terms.far), bits);
                near |= static_cast<unsigned>(bits[0]) << first;
            }
            for (; near != 0; near &= near - 1)
                open[count++] = group.below[std::countr_zero(near)];
            at = group.next;
        }
}

double windingDispatched(std::span<const WindingGroup> groups, const base::Vec3d& x) {
    WindingSums<1> sums;
    forWindingTerms(groups, x, [&](const WindingTerms& t, std::size_t first) {
        sums.add(0, first, hn::IfThenElseZero(t.counts, hn::Div(t.along, t.cube)));
    });
    return sums.sum(0);
}

base::Vec3d windingGradientDispatched(std::span<const WindingGroup> groups, const base::Vec3d& x) {
    WindingSums<3> sums;
    forWindingTerms(groups, x, [&](const WindingTerms& t, std::size_t first) {
        const WindingV share = hn::Div(hn::Mul(hn::Set(WindingD(), 3.0f), t.along), t.square);
        const auto add = [&](std::size_t row, WindingV p, WindingV area) {
            sums.add(row, first, hn::IfThenElseZero(t.counts, hn::Div(hn::MulSub(p, share, area), t.cube)));
        };
        add(0, t.px, t.ax), add(1, t.py, t.ay), add(2, t.pz, t.az);
    });
    return {sums.sum(0), sums.sum(1), sums.sum(2)};
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(windingDispatched);
HWY_EXPORT(windingGradientDispatched);

double windingKernel(std::span<const WindingGroup> groups, const base::Vec3d& x) {
    return HWY_DYNAMIC_DISPATCH(windingDispatched)(groups, x);
}

base::Vec3d windingGradientKernel(std::span<const WindingGroup> groups, const base::Vec3d& x) {
    return HWY_DYNAMIC_DISPATCH(windingGradientDispatched)(groups, x);
}

} // namespace surface
#endif
