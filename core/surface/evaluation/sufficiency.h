// Whether the surfels around a position are enough to define a surface there (surface/README 2.5). Internal to the
// room.
#pragma once

#include "core/surface/evaluation/moments.h"
#include "core/surface/surface.h"

namespace surface {

/// Below this sum of weights a position counts as outside (theta underflows near r = 1; surface/README 8.3).
template <class T>
constexpr T leastWeight = std::is_same_v<T, float> ? T(1e-6) : T(1e-12);
constexpr int leastSamples = 3;      ///< surfels in support that a frame needs
constexpr double leastSpread = 1e-6; ///< variance below which all are at one place, of h^2: what float can tell

/// What is missing; None where the surfels are enough.
template <class T, int O>
Cause scarcityOf(const Moments<T, O>& m) {
    if (!(m.one.v > leastWeight<T>))
        return Cause::NoSupport;
    if (m.samples < leastSamples)
        return m.samples == 1 ? Cause::OnePoint : Cause::TooFew;
    const T unit = m.unit / m.one.v, square = m.square.v / m.one.v;
    const T spread = square - lengthSq(valueOf(m.q) / m.one.v);
    return spread > T(leastSpread) * std::max(unit * unit, square) ? Cause::None : Cause::Coincident;
}

/// The same for sums `m` of the clusters at x by `options`. Interpolating weights bring every sum to one place as x
/// comes to a surfel; there the question is put with plain ones.
template <class T, int O>
Cause scarcity(ClusterSpan clusters, const base::Vec3<T>& x, SumOptions options, const Moments<T, O>& m) {
    if (!options.interpolating)
        return scarcityOf(m);
    options.interpolating = false;
    options.outer = Outer::None;
    Moments<T, 0> plain;
    sum(clusters, x, options, plain);
    return scarcityOf(plain);
}

} // namespace surface
