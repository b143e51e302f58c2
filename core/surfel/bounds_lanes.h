// Eight bounds in lanes, so that one vector test covers them all: the children of a tree node, the clusters of a block.
//
// A bound is a tight box of positions with the largest support radius among them. Unused lanes hold empty boxes with
// support 0: infinitely far from everything, in no ball and in no box. Masks have bit i for lane i.
// The loops are plain so that the compiler turns each into a few vector instructions; every operation is monotonic
// in the bounds, so that a bound that contains another answers yes whenever the inner one does, bit for bit.
#pragma once

#include "core/base/box.h"
#include "core/base/ray.h"

#include <cstdint>

namespace surfel {

constexpr int laneCount = 8;

/// How far from a cluster's samples the surface may run, as a part of their support: smaller loses ray hits (TREE.md).
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
    /// Lanes that may have weight at x, supports multiplied by `reach`: distance(x, box) < reach maxSupport (alg. 5.1.2).
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

constexpr unsigned laneBit[laneCount] = {1, 2, 4, 8, 16, 32, 64, 128};

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

inline void BoundsLanes::distanceSq(const base::Vec3f& x, float (&out)[laneCount]) const {
    const float px = x.x, py = x.y, pz = x.z; // copies, which no store to `out` can change
    for (int i = 0; i < laneCount; ++i) {
        const float dx = smaller(larger(px, loX[i]), hiX[i]) - px;
        const float dy = smaller(larger(py, loY[i]), hiY[i]) - py;
        const float dz = smaller(larger(pz, loZ[i]), hiZ[i]) - pz;
        out[i] = dx * dx + dy * dy + dz * dz;
    }
}

inline unsigned BoundsLanes::supporting(const base::Vec3f& x, float reach) const {
    float d[laneCount];
    distanceSq(x, d);
    unsigned mask = 0;
    for (int i = 0; i < laneCount; ++i) {
        const float support = reach * maxSupport[i];
        mask |= d[i] < support * support ? laneBit[i] : 0;
    }
    return mask;
}

inline unsigned BoundsLanes::supporting(const base::Box3f& q, float reach) const {
    unsigned mask = 0;
    for (int i = 0; i < laneCount; ++i) {
        const float dx = larger(larger(loX[i] - q.hi.x, q.lo.x - hiX[i]), 0.0f);
        const float dy = larger(larger(loY[i] - q.hi.y, q.lo.y - hiY[i]), 0.0f);
        const float dz = larger(larger(loZ[i] - q.hi.z, q.lo.z - hiZ[i]), 0.0f);
        const float support = reach * maxSupport[i];
        mask |= dx * dx + dy * dy + dz * dz < support * support ? laneBit[i] : 0;
    }
    return mask;
}

inline unsigned BoundsLanes::within(const base::Vec3f& centre, float radiusSq) const {
    float d[laneCount];
    distanceSq(centre, d);
    unsigned mask = 0;
    for (int i = 0; i < laneCount; ++i)
        mask |= d[i] <= radiusSq ? laneBit[i] : 0;
    return mask;
}

inline unsigned BoundsLanes::meeting(const RaySlabs& ray, float (&enter)[laneCount], float (&leave)[laneCount]) const {
    const float* lows[3] = {loX, loY, loZ};
    const float* highs[3] = {hiX, hiY, hiZ};
    for (int i = 0; i < laneCount; ++i)
        enter[i] = 0, leave[i] = std::numeric_limits<float>::infinity();
    for (int k = 0; k < 3; ++k) {
        const float *lo = lows[k], *hi = highs[k], origin = ray.origin[k], inverse = ray.inverse[k];
        if (ray.parallel[k]) {
            for (int i = 0; i < laneCount; ++i) {
                const float reach = surfaceReach * maxSupport[i];
                leave[i] = origin < lo[i] - reach || origin > hi[i] + reach ? -1.0f : leave[i];
            }
            continue;
        }
        for (int i = 0; i < laneCount; ++i) {
            const float reach = surfaceReach * maxSupport[i];
            const float a = (lo[i] - reach - origin) * inverse, b = (hi[i] + reach - origin) * inverse;
            enter[i] = larger(enter[i], smaller(a, b));
            leave[i] = smaller(leave[i], larger(a, b));
        }
    }
    unsigned mask = 0;
    for (int i = 0; i < laneCount; ++i)
        mask |= enter[i] <= leave[i] ? laneBit[i] : 0;
    return mask;
}

} // namespace surfel
