// Interpolating weights (surface/README 2.10): where a surfel is at the position itself, it is the answer: f = 0, c =
// p, n = g = n_i.
#pragma once

#include "core/surface/evaluation/moments.h"
#include "core/surfel/surfel_block.h"

#include <optional>

namespace surface {

/// This close to a surfel, in h, the answer is the surfel itself; its Hessian is taken a little above it, where
/// formulas hold.
constexpr double atSurfel = 1e-12, besideSurfel = 1e-5;

template <class T>
struct SurfelHere {
    base::Vec3<T> position, normal; ///< unit
    T support;
};

/// The first surfel with a normal that is at x; supports are multiplied by `scale`.
template <class T>
std::optional<SurfelHere<T>> surfelHere(ClusterSpan clusters, const base::Vec3<T>& x, float scale) {
    constexpr int lanes = surfel::clusterSize;
    for (const float* c : clusters)
        for (int i = 0; i < lanes; ++i) {
            const base::Vec3d p{c[i], c[lanes + i], c[2 * lanes + i]};
            const base::Vec3d n{c[surfel::NormalX * lanes + i], c[surfel::NormalY * lanes + i],
                                c[surfel::NormalZ * lanes + i]};
            const double h = static_cast<double>(c[surfel::Support * lanes + i] * scale);
            if (lengthSq(n) > 0 && distance(p, base::cast<double>(x)) < atSurfel * h)
                return SurfelHere<T>{base::cast<T>(p), base::normalized(base::cast<T>(n)), static_cast<T>(h)};
        }
    return std::nullopt;
}

} // namespace surface
