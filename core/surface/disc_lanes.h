// A ray against bounds and surfels in lanes: boxes met, chords in balls, crossings of discs. For kernels that are
// compiled once per instruction set.
#if defined(POINTCLAY_DISC_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_DISC_LANES_H
#undef POINTCLAY_DISC_LANES_H
#else
#define POINTCLAY_DISC_LANES_H
#endif

#include "core/surfel/surfel_block.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int lanes = surfel::clusterSize;
using D = hn::CappedTag<float, surfel::clusterSize>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

/// Of the support, a disc's core: the surface near a ray that passes closely is nearest to a disc whose core it meets.
constexpr float coreReach = 0.3f;
/// Of the support: a ray closer than this to the core of a disc that it does not cross may meet the surface there.
constexpr float thickness = 0.04f;
struct Slabs {
    float origin[3], inverse[3];

    Slabs() = default;
    explicit Slabs(const base::Rayf& ray) {
        constexpr float tiny = 1e-20f; // its inverse times any length is finite and beyond all boxes
        for (std::size_t k = 0; k < 3; ++k) {
            const float d = ray.direction[k];
            origin[k] = ray.origin[k];
            inverse[k] = 1.0f / (std::abs(d) < tiny ? std::copysign(tiny, d) : d);
        }
    }
};

/// Lanes whose surface bound the ray meets in [least, most], and where it enters.
HWY_INLINE unsigned meeting(const surfel::BoundsLanes& bounds, const Slabs& ray, float least, float most,
                            float* HWY_RESTRICT enter) {
    const hn::CappedTag<float, surfel::laneCount> d;
    const int width = static_cast<int>(hn::Lanes(d));
    const float *lows[3] = {bounds.loX, bounds.loY, bounds.loZ}, *highs[3] = {bounds.hiX, bounds.hiY, bounds.hiZ};
    unsigned out = 0;
    for (int first = 0; first < surfel::laneCount; first += width) {
        const auto reach = hn::Mul(hn::Load(d, bounds.maxSupport + first), hn::Set(d, surfel::surfaceReach));
        auto begin = hn::Set(d, least), end = hn::Set(d, most);
        for (int k = 0; k < 3; ++k) {
            const auto origin = hn::Set(d, ray.origin[k]), inverse = hn::Set(d, ray.inverse[k]);
            const auto a = hn::Mul(hn::Sub(hn::Sub(hn::Load(d, lows[k] + first), reach), origin), inverse);
            const auto b = hn::Mul(hn::Sub(hn::Add(hn::Load(d, highs[k] + first), reach), origin), inverse);
            begin = hn::Max(begin, hn::Min(a, b));
            end = hn::Min(end, hn::Max(a, b));
        }
        hn::Store(begin, d, enter + first);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Le(begin, end), bits);
        out |= static_cast<unsigned>(bits[0]) << first;
    }
    return out;
}

/// A group of surfels seen along the ray: all is told at the points of the ray nearest to them, which is exact far from
/// the origin too.
struct Seen {
    V along, distanceSq, h; ///< t of those points, squared distances, supports
    V q[3];                 ///< from there to the surfels
};

HWY_INLINE Seen see(D d, const float* c, const base::Rayf& ray) {
    Seen out;
    out.along = hn::Zero(d);
    out.distanceSq = hn::Zero(d);
    V direction[3];
    for (std::size_t k = 0; k < 3; ++k) {
        direction[k] = hn::Set(d, ray.direction[k]);
        out.q[k] = hn::Sub(hn::Load(d, c + k * lanes), hn::Set(d, ray.origin[k]));
        out.along = hn::MulAdd(out.q[k], direction[k], out.along);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        out.q[k] = hn::NegMulAdd(out.along, direction[k], out.q[k]);
        out.distanceSq = hn::MulAdd(out.q[k], out.q[k], out.distanceSq);
    }
    out.h = hn::Load(d, c + surfel::Support * lanes);
    return out;
}

/// Half the chord of the ray in balls of `reach`; zero for those that it misses.
HWY_INLINE V halfChord(D d, const Seen& seen, V reach) {
    return hn::Sqrt(hn::Max(hn::MulSub(reach, reach, seen.distanceSq), hn::Zero(d)));
}

struct Crossings {
    V t, weight; ///< of the crossing, or of the ray's nearest point; 1 at the disc's centre, 0 at its rim
    V slope, support;
    M crossed, brushed;
};

HWY_INLINE Crossings cross(D d, const float* c, const base::Rayf& ray) {
    const Seen seen = see(d, c, ray);
    V slope = hn::Zero(d), height = hn::Zero(d); // n.d, and of the centre over the ray's point
    for (std::size_t k = 0; k < 3; ++k) {
        const V n = hn::Load(d, c + (surfel::NormalX + k) * lanes);
        slope = hn::MulAdd(n, hn::Set(d, ray.direction[k]), slope);
        height = hn::MulAdd(n, seen.q[k], height);
    }
    const V reach = hn::Mul(seen.h, hn::Set(d, surfel::surfaceReach)), core = hn::Mul(seen.h, hn::Set(d, coreReach));
    const V steep = hn::Abs(slope), high = hn::Abs(height);
    const V coreChord = halfChord(d, seen, core);
    Crossings out;
    out.crossed = hn::Lt(high, hn::Mul(steep, halfChord(d, seen, reach)));
    const V most = hn::MulAdd(seen.h, hn::Set(d, thickness), hn::Mul(steep, coreChord));
    out.brushed = hn::AndNot(out.crossed, hn::And(hn::Gt(coreChord, hn::Zero(d)), hn::Lt(high, most)));
    const V beyond = hn::IfThenElseZero(out.crossed, hn::Div(height, slope));
    out.t = hn::Add(seen.along, beyond);
    const V radiusSq = hn::Div(hn::MulAdd(beyond, beyond, seen.distanceSq), hn::Mul(reach, reach));
    const V share = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0f), radiusSq));
    out.weight = hn::IfThenElseZero(out.crossed, hn::Mul(hn::Mul(share, share), steep));
    out.slope = slope;
    out.support = seen.h;
    return out;
}

/// Lane by lane in one order on every instruction set.
HWY_INLINE float sumOf(const float* row) {
    float r[8];
    for (int i = 0; i < 8; ++i)
        r[i] = row[i] + row[i + 8];
    for (int half = 4; half > 0; half /= 2)
        for (int i = 0; i < half; ++i)
            r[i] += r[i + half];
    return r[0];
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
