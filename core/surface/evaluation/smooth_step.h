// The quintic step t^3 (10 - 15 t + 6 t^2) from 0 at t = 0 to 1 at t = 1: no corner in it, nor in its first and second
// derivatives. What must set in somewhere sets in by it.
#pragma once

#include "core/surface/evaluation/jet.h"

namespace surface {

/// The step at t with its derivatives.
template <class T>
struct SmoothStep {
    T v, d = 0, dd = 0, ddd = 0;

    constexpr explicit SmoothStep(T t) : v(t > T(0) ? T(1) : T(0)) {
        if (!(t > T(0) && t < T(1)))
            return;
        const T rest = T(1) - t;
        v = t * t * t * (T(10) + t * (T(6) * t - T(15)));
        d = T(30) * t * t * rest * rest;
        dd = T(60) * t * rest * (rest - t);
        ddd = T(60) * (T(1) - T(6) * t * rest);
    }
};

/// 0 where a <= from, 1 where a >= to.
template <class T, int O>
Jet<T, O> stepBetween(const Jet<T, O>& a, double from, double to) {
    const T rise = static_cast<T>(1 / (to - from));
    const SmoothStep<T> s((a.v - static_cast<T>(from)) * rise);
    return chain(a, s.v, s.d * rise, s.dd * rise * rise, s.ddd * rise * rise * rise);
}

} // namespace surface
