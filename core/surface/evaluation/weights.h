// The weights of surfels at a place, one by one and without derivatives: for means of what surfels carry. Sums that
// define the surface come from the kernels of this room, which have the same formulas in lanes (kernel_weights.h).
#pragma once

#include "core/surface/surface.h"
#include "core/surfel/shape.h"

#include <bit>
#include <concepts>

namespace surface {

/// Wendland's C2 function at r = distance / support < 1.
template <std::floating_point T>
constexpr T wendlandC2(T r) {
    const T t = (1 - r) * (1 - r);
    return t * t * (4 * r + 1);
}

/// theta (surface/README 2.1); 0 from the support on. Whether the definition interpolates has no say: over r^2 the
/// nearest surfel would be all that counts.
template <std::floating_point T>
T weightAt(Weight weight, T distanceSq, std::type_identity_t<T> support) {
    if (!(distanceSq < support * support))
        return 0;
    if (weight == Weight::Gaussian) {
        const T scale = support / static_cast<T>(gaussianReach);
        return std::exp(-distanceSq / (scale * scale));
    }
    const T r = std::sqrt(distanceSq) / support;
    if (weight == Weight::Wendland)
        return wendlandC2(r);
    const T t = (1 - r) * (1 - r);
    return t * t * t * ((35 * r + 18) * r + 3) / 3;
}

/// A bit for each surfel of the cluster that `x` is in the support of; squared distances of all of them, in the metric
/// of their shapes (channel `shape`, 0 for balls).
unsigned withinSupport(const surfel::SurfelBlock& block, int cluster, const base::Vec3f& x, float* distanceSq,
                       int shape = 0);

/// fn(slot, theta) for the surfels of a cluster that have weight at `x`.
template <class Fn>
void forWeights(const surfel::SurfelBlock& block, int cluster, Weight weight, const base::Vec3f& x, const Fn& fn,
                int shape = 0) {
    float distanceSq[surfel::clusterSize];
    for (unsigned in = withinSupport(block, cluster, x, distanceSq, shape); in != 0; in &= in - 1) {
        const int lane = std::countr_zero(in), slot = cluster * surfel::clusterSize + lane;
        if (const float theta = weightAt(weight, distanceSq[lane], block.support(slot)); theta > 0)
            fn(slot, theta);
    }
}

/// fn(block, slot, theta) for the surfels of a model that have weight at `x`, in tree order.
template <class Fn>
void forWeights(const Surface& surface, const base::Vec3f& x, const Fn& fn) {
    const Weight weight = surface.definition().weight;
    const int shape = surfel::shapeChannel(*surface.tree().layout());
    surface.tree().forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        forWeights(
            block, cluster, weight, x, [&](int slot, float theta) { fn(block, slot, theta); }, shape);
    });
}

} // namespace surface
