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
/// Of the support: a ray closer than this to the core of a disc that it does not cross may meet the surface there. More
/// behind the disc, where the surface lies that curves away from it sharply.
constexpr float thickness = 0.04f, thicknessBehind = 0.1f;

/// A ray prepared for boxes.
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

/// Where bounds lie in memory: arrays of lanes.
struct BoundsArrays {
    const float *lo[3], *hi[3], *support;

    explicit BoundsArrays(const surfel::BoundsLanes& b)
        : lo{b.loX, b.loY, b.loZ}, hi{b.hiX, b.hiY, b.hiZ}, support(b.maxSupport) {}
    /// 16 at once: seven arrays one behind the other.
    explicit BoundsArrays(const float* group)
        : lo{group, group + lanes, group + 2 * lanes}, hi{group + 3 * lanes, group + 4 * lanes, group + 5 * lanes},
          support(group + 6 * lanes) {}
};

/// Bounds are entered a little early and left a little late: more than rounding takes.
constexpr float earlyBy = 0.999999f, lateBy = 1.000001f;

/// Lanes whose surface bound the ray meets in [least, most], and where it enters, a little early: nothing in a bound
/// has a smaller t, rounding included, so that what a walk finds does not depend on its order.
template <int count>
HWY_INLINE unsigned meeting(const BoundsArrays& bounds, const Slabs& ray, float least, float most,
                            float* HWY_RESTRICT enter) {
    const hn::CappedTag<float, count> d;
    const int width = static_cast<int>(hn::Lanes(d));
    const auto early = hn::Set(d, earlyBy), late = hn::Set(d, lateBy);
    unsigned out = 0;
    for (int first = 0; first < count; first += width) {
        const auto reach = hn::Mul(hn::Load(d, bounds.support + first), hn::Set(d, surfel::surfaceReach));
        auto begin = hn::Zero(d), end = hn::Set(d, std::numeric_limits<float>::max());
        for (int k = 0; k < 3; ++k) {
            const auto origin = hn::Set(d, ray.origin[k]), inverse = hn::Set(d, ray.inverse[k]);
            const auto a = hn::Mul(hn::Sub(hn::Sub(hn::Load(d, bounds.lo[k] + first), reach), origin), inverse);
            const auto b = hn::Mul(hn::Sub(hn::Add(hn::Load(d, bounds.hi[k] + first), reach), origin), inverse);
            begin = hn::Max(begin, hn::Min(a, b));
            end = hn::Min(end, hn::Max(a, b));
        }
        begin = hn::Max(hn::Mul(begin, early), hn::Set(d, least));
        end = hn::Min(hn::Mul(end, late), hn::Set(d, most));
        hn::Store(begin, d, enter + first);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Le(begin, end), bits);
        out |= (bits[0] | static_cast<unsigned>(bits[1]) << 8) << first;
    }
    return out;
}

/// Surfels of a cluster in registers, for several rays.
struct Discs {
    V p[3], n[3], h;

    /// Those from `first` on, as many as a register holds.
    static HWY_INLINE Discs load(D d, const float* cluster, int first) {
        const float* c = cluster + first;
        Discs out;
        for (std::size_t k = 0; k < 3; ++k) {
            out.p[k] = hn::Load(d, c + k * lanes);
            out.n[k] = hn::Load(d, c + (surfel::NormalX + k) * lanes);
        }
        out.h = hn::Load(d, c + surfel::Support * lanes);
        return out;
    }
};

/// A group of surfels seen along the ray: all is told at the points of the ray nearest to them, which is exact far from
/// the origin too.
struct Seen {
    V along, distanceSq; ///< t of those points, squared distances
    V q[3];              ///< from there to the surfels
};

HWY_INLINE Seen see(D d, const Discs& discs, const base::Rayf& ray) {
    Seen out;
    out.along = hn::Zero(d);
    out.distanceSq = hn::Zero(d);
    V direction[3];
    for (std::size_t k = 0; k < 3; ++k) {
        direction[k] = hn::Set(d, ray.direction[k]);
        out.q[k] = hn::Sub(discs.p[k], hn::Set(d, ray.origin[k]));
        out.along = hn::MulAdd(out.q[k], direction[k], out.along);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        out.q[k] = hn::NegMulAdd(out.along, direction[k], out.q[k]);
        out.distanceSq = hn::MulAdd(out.q[k], out.q[k], out.distanceSq);
    }
    return out;
}

/// Half the chord of the ray in balls of `reach`; zero for those that it misses.
HWY_INLINE V halfChord(D d, const Seen& seen, V reach) {
    return hn::Sqrt(hn::Max(hn::MulSub(reach, reach, seen.distanceSq), hn::Zero(d)));
}

/// How the ray passes the discs of a group of surfels.
struct Crossings {
    Seen seen;
    V slope, height; ///< n.d, and of the centre over the ray's nearest point
    M crossed, brushed;

    /// Where it crosses them, or is nearest to their centres.
    V t() const { return hn::Add(seen.along, hn::IfThenElseZero(crossed, hn::Div(height, slope))); }
};

HWY_INLINE Crossings cross(D d, const Discs& discs, const base::Rayf& ray) {
    Crossings out;
    out.seen = see(d, discs, ray);
    out.slope = out.height = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k) {
        out.slope = hn::MulAdd(discs.n[k], hn::Set(d, ray.direction[k]), out.slope);
        out.height = hn::MulAdd(discs.n[k], out.seen.q[k], out.height);
    }
    // crossed: |height| below |slope| times half the chord
    const V reach = hn::Mul(discs.h, hn::Set(d, surfel::surfaceReach));
    const V chordSq = hn::MulSub(reach, reach, out.seen.distanceSq);
    out.crossed = hn::Lt(hn::Mul(out.height, out.height), hn::Mul(hn::Mul(out.slope, out.slope), chordSq));
    // in the core all the chord is higher, but not by more than the thickness
    const V core = hn::Mul(discs.h, hn::Set(d, coreReach)), coreSq = hn::MulSub(core, core, out.seen.distanceSq);
    const V thick = hn::IfThenElse(hn::Gt(out.height, hn::Zero(d)), hn::Set(d, thicknessBehind), hn::Set(d, thickness));
    const V over = hn::NegMulAdd(discs.h, thick, hn::Abs(out.height));
    const M close = hn::Lt(hn::Mul(over, hn::Abs(over)), hn::Mul(hn::Mul(out.slope, out.slope), coreSq));
    out.brushed = hn::AndNot(out.crossed, hn::And(hn::Gt(coreSq, hn::Zero(d)), close));
    return out;
}

/// 1 for crossings at the disc's centre, 0 at its rim, less where it is crossed at a flat angle.
HWY_INLINE V weightOf(D d, const Discs& discs, const Crossings& c, V t) {
    const V beyond = hn::Sub(t, c.seen.along), reach = hn::Mul(discs.h, hn::Set(d, surfel::surfaceReach));
    const V radiusSq = hn::Div(hn::MulAdd(beyond, beyond, c.seen.distanceSq), hn::Mul(reach, reach));
    const V share = hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0f), radiusSq));
    return hn::IfThenElseZero(c.crossed, hn::Mul(hn::Mul(share, share), hn::Abs(c.slope)));
}

/// Lane by lane in one order on every instruction set: i and i + 8, i and i + 4, i and i + 2, the last two.
HWY_INLINE float sumOf(const float* row) {
#if HWY_MAX_BYTES >= 32
    const hn::FixedTag<float, 8> d8;
    const hn::FixedTag<float, 4> d4;
    const auto eight = hn::Add(hn::Load(d8, row), hn::Load(d8, row + 8));
    const auto four = hn::Add(hn::LowerHalf(d4, eight), hn::UpperHalf(d4, eight));
    const auto two = hn::Add(four, hn::Shuffle1032(four));
    return hn::GetLane(hn::Add(two, hn::Shuffle2301(two)));
#else
    float r[8];
    for (int i = 0; i < 8; ++i)
        r[i] = row[i] + row[i + 8];
    for (int half = 4; half > 0; half /= 2)
        for (int i = 0; i < half; ++i)
            r[i] += r[i + half];
    return r[0];
#endif
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
