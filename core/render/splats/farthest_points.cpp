#include "core/render/splats/farthest_points.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/splats/farthest_points.cpp"
#include "core/base/instruction_sets.h"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Takes a point into account; returns the farthest one then, the first of several.
int nearTo(PointLanes& p, int chosen, float place, float turnSq, bool oriented) {
    const HWY_CAPPED(float, 16) d;
    const auto cx = hn::Set(d, p.x[chosen]), cy = hn::Set(d, p.y[chosen]), cz = hn::Set(d, p.z[chosen]);
    const auto ux = hn::Set(d, p.nx[chosen]), uy = hn::Set(d, p.ny[chosen]), uz = hn::Set(d, p.nz[chosen]);
    const auto number = hn::Set(d, place), twice = hn::Set(d, 2 * turnSq), one = hn::Set(d, 1.0f);
    auto best = hn::Set(d, -2.0f), at = hn::Zero(d);
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int i = 0; i < p.size; i += lanes) {
        const auto dx = hn::Sub(hn::Load(d, p.x + i), cx), dy = hn::Sub(hn::Load(d, p.y + i), cy),
                   dz = hn::Sub(hn::Load(d, p.z + i), cz);
        auto cosine = hn::MulAdd(hn::Load(d, p.nx + i), ux,
                                 hn::MulAdd(hn::Load(d, p.ny + i), uy, hn::Mul(hn::Load(d, p.nz + i), uz)));
        cosine = oriented ? cosine : hn::Abs(cosine);
        const auto distance =
            hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::MulAdd(dz, dz, hn::Mul(twice, hn::Sub(one, cosine)))));
        const auto before = hn::Load(d, p.apart + i);
        const auto closer = hn::Lt(distance, before);
        const auto apart = hn::IfThenElse(closer, distance, before);
        hn::Store(apart, d, p.apart + i);
        hn::Store(hn::IfThenElse(closer, number, hn::Load(d, p.owner + i)), d, p.owner + i);
        const auto farther = hn::Gt(apart, best);
        best = hn::IfThenElse(farther, apart, best);
        at = hn::IfThenElse(farther, hn::Iota(d, static_cast<float>(i)), at);
    }
    const auto most = hn::MaxOfLanes(d, best);
    return static_cast<int>(hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(hn::Eq(best, most), at, hn::Set(d, 1e9f)))));
}

} // namespace HWY_NAMESPACE
} // namespace render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace render {

HWY_EXPORT(nearTo);

PointLanes::PointLanes(const surfel::SurfelBlock& block) : size(block.size()) {
    for (int first = 0, c = 0; first < size; first += surfel::clusterSize, ++c) {
        const auto copy = [&](float* to, int channel) {
            std::copy_n(block.channel(c, channel), surfel::clusterSize, to + first);
        };
        copy(x, surfel::X), copy(y, surfel::Y), copy(z, surfel::Z);
        copy(nx, surfel::NormalX), copy(ny, surfel::NormalY), copy(nz, surfel::NormalZ);
        copy(support, surfel::Support);
    }
    std::fill_n(apart, size, std::numeric_limits<float>::infinity());
    std::fill(apart + size, apart + most, -1.0f);
    std::fill_n(owner, most, 0.0f);
}

int PointLanes::choose(int count, float turn, bool oriented, int* out) {
    int k = 0;
    for (int next = 0; k < count; ++k) {
        if (k > 0 && apart[next] <= 0)
            break;
        out[k] = next;
        apart[next] = -1, owner[next] = static_cast<float>(k); // its own, whatever rounding and unknown normals say
        next = HWY_DYNAMIC_DISPATCH(nearTo)(*this, next, static_cast<float>(k), turn * turn, oriented);
    }
    return k;
}

} // namespace render
#endif
