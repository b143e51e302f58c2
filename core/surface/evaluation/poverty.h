// Whether the surfels around a position are enough to tell a surface: the first test of alg. 2.4. Internal to the room.
#pragma once

#include "core/surface/evaluation/moments.h"
#include "core/surface/surface.h"

namespace surface {

/// Below this sum of weights a position counts as outside (theta underflows near r = 1; alg. 2.1).
template <class T>
constexpr T leastWeight = std::is_same_v<T, float> ? T(1e-6) : T(1e-12);
constexpr int leastSamples = 3;      ///< surfels in support that a frame needs
constexpr double leastSpread = 1e-6; ///< variance below which all are at one place, of h^2: what float can tell

/// None where they are.
template <class T, int O>
Cause povertyOf(const Moments<T, O>& m) {
    if (!(m.one.v > leastWeight<T>))
        return Cause::NoSupport;
    if (m.samples < leastSamples)
        return m.samples == 1 ? Cause::OnePoint : Cause::TooFew;
    const T unit = m.unit / m.one.v, square = m.square.v / m.one.v;
    const T spread = square - lengthSq(valueOf(m.q) / m.one.v);
    return spread > T(leastSpread) * std::max(unit * unit, square) ? Cause::None : Cause::Coincident;
}

} // namespace surface
