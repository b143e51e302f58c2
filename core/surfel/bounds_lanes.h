// Eight bounds in lanes, so that one vector test covers them all: the children of a tree node, the clusters of a block.
//
// A bound is a tight box of positions with the largest support radius among them. Unused lanes hold empty boxes with
// support 0: infinitely far from everything, in no ball and in no box. Masks have bit i for lane i.
// Every operation is monotonic in the bounds, so that a bound that contains another answers yes whenever the inner one
// does, bit for bit.
#pragma once

#include "core/base/box.h"
#include "core/base/ray.h"
#include "core/surfel/lanes.h"

#include <cstdint>

namespace surfel {

/// How far from a cluster's samples the surface may run, in supports: smaller loses ray hits (surfel/README 2.2).
constexpr float surfaceReach = 0.7f;

/// A ray prepared for tests against many boxes: the same arithmetic as base::clip.
struct RaySlabs {
    explicit RaySlabs(const base::Rayf& ray);

    float origin[3], inverse[3];
    bool parallel[3]; ///< no direction along this axis: inside the slab or not, at every t
};

struct alignas(32) BoundsLanes {
    float loX[laneCount], loY[laneCount], loZ[laneCount], hiX[laneCount], hiY[laneCount], hiZ[laneCount];
    float maxSupport[laneCount];

    BoundsLanes();
    void set(int lane, const base::Box3f& box, float support);
    base::Box3f box(int lane) const { return {{loX[lane], loY[lane], loZ[lane]}, {hiX[lane], hiY[lane], hiZ[lane]}}; }

    /// Squared distances from x to the boxes.
    void distanceSq(const base::Vec3f& x, float (&out)[laneCount]) const;
    /// Lanes that may have weight at x, supports multiplied by `reach`: distance(x, box) < reach maxSupport
    /// (surfel/README 2.2).
    unsigned supporting(const base::Vec3f& x, float reach = 1) const;
    /// Lanes that may have weight somewhere in `q`.
    unsigned supporting(const base::Box3f& q, float reach = 1) const;
    /// Lanes whose box comes within the root of `radiusSq` of `centre`.
    unsigned within(const base::Vec3f& centre, float radiusSq) const;
    /// Lanes whose surface bound meets the ray, and the intervals in which it does. Unused lanes give no sense: mask.
    unsigned meeting(const RaySlabs& ray, float (&enter)[laneCount], float (&leave)[laneCount]) const;
};

/// By value, unlike std::max and std::min, so that loops over lanes become vector instructions.
inline float larger(float a, float b) {
    return a < b ? b : a;
}
inline float smaller(float a, float b) {
    return b < a ? b : a;
}

inline RaySlabs::RaySlabs(const base::Rayf& ray) {
    for (std::size_t k = 0; k < 3; ++k) {
        origin[k] = ray.origin[k];
        inverse[k] = 1.0f / ray.direction[k];
        parallel[k] = !std::isfinite(inverse[k]);
    }
}

inline BoundsLanes::BoundsLanes() {
    for (int lane = 0; lane < laneCount; ++lane)
        set(lane, {}, 0);
}

inline void BoundsLanes::set(int lane, const base::Box3f& box, float support) {
    loX[lane] = box.lo.x, loY[lane] = box.lo.y, loZ[lane] = box.lo.z;
    hiX[lane] = box.hi.x, hiY[lane] = box.hi.y, hiZ[lane] = box.hi.z;
    maxSupport[lane] = support;
}

namespace detail {

/// Squared distances from the box [lo, hi], a point where both are the same, to the lanes' boxes.
inline Lanes distancesSq(const BoundsLanes& b, const base::Vec3f& lo, const base::Vec3f& hi) {
    const Lanes zero(0.0f);
    const Lanes dx = max(max(Lanes::load(b.loX) - hi.x, Lanes(lo.x) - Lanes::load(b.hiX)), zero);
    const Lanes dy = max(max(Lanes::load(b.loY) - hi.y, Lanes(lo.y) - Lanes::load(b.hiY)), zero);
    const Lanes dz = max(max(Lanes::load(b.loZ) - hi.z, Lanes(lo.z) - Lanes::load(b.hiZ)), zero);
    return dx * dx + dy * dy + dz * dz;
}

} // namespace detail

inline void BoundsLanes::distanceSq(const base::Vec3f& x, float (&out)[laneCount]) const {
    detail::distancesSq(*this, x, x).store(out);
}

inline unsigned BoundsLanes::supporting(const base::Vec3f& x, float reach) const {
    const Lanes support = Lanes(reach) * Lanes::load(maxSupport);
    return less(detail::distancesSq(*this, x, x), support * support);
}

inline unsigned BoundsLanes::supporting(const base::Box3f& q, float reach) const {
    const Lanes support = Lanes(reach) * Lanes::load(maxSupport);
    return less(detail::distancesSq(*this, q.lo, q.hi), support * support);
}

inline unsigned BoundsLanes::within(const base::Vec3f& centre, float radiusSq) const {
    return lessOrEqual(detail::distancesSq(*this, centre, centre), radiusSq);
}

inline unsigned BoundsLanes::meeting(const RaySlabs& ray, float (&enter)[laneCount], float (&leave)[laneCount]) const {
    const float* lows[3] = {loX, loY, loZ};
    const float* highs[3] = {hiX, hiY, hiZ};
    const Lanes reach = Lanes(surfaceReach) * Lanes::load(maxSupport);
    Lanes first(0.0f), last(std::numeric_limits<float>::infinity());
    unsigned beside = 0;
    for (int k = 0; k < 3; ++k) {
        const Lanes lo = Lanes::load(lows[k]) - reach, hi = Lanes::load(highs[k]) + reach, origin(ray.origin[k]);
        if (ray.parallel[k]) {
            beside |= less(origin, lo) | less(hi, origin);
            continue;
        }
        const Lanes inverse(ray.inverse[k]);
        const Lanes a = (lo - origin) * inverse, b = (hi - origin) * inverse;
        first = max(first, min(a, b));
        last = min(last, max(a, b));
    }
    first.store(enter);
    last.store(leave);
    return lessOrEqual(first, last) & ~beside;
}

} // namespace surfel
