// Sums about a moving x, from those of the first stage, whose monomials stay where x is (moments.h). Written with jets,
// so that derivatives are exact. Shared by both precisions.
#pragma once

#include "core/surface/evaluation/moments.h"

namespace surface {

/// |m|/w, m the sum of the normals: 1 where they agree, 0 where they cancel.
template <class T, int O>
T agreementOf(const Moments<T, O>& m) {
    return length(valueOf(m.n)) / m.one.v;
}

/// sum theta n_i.(x - p_i), x moving.
template <class T, int O>
Jet<T, O> movingHeight(const Moments<T, O>& m) {
    Jet<T, O> out = -m.height;
    for (int a = 0; a < 3; ++a)
        out += timesCoordinate(a, m.n[static_cast<std::size_t>(a)]);
    return out;
}

/// sum theta q q^T, q = p - x moving: q_a q_b - x_a q_b - x_b q_a + x_a x_b about where x is.
template <class T, int O>
void movingOuter(const Moments<T, O>& m, Jet<T, O> (&out)[6]) {
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) {
            Jet<T, O>& s = out[sym(a, b)];
            s = m.outer[sym(a, b)];
            if constexpr (O >= 1)
                s = s - timesCoordinate(a, m.q[static_cast<std::size_t>(b)]) -
                    timesCoordinate(b, m.q[static_cast<std::size_t>(a)]);
            if constexpr (O >= 2)
                s += timesCoordinate(a, timesCoordinate(b, m.one));
        }
}

/// J J^T of the centroid's gradient J_ab = dc_a/dx_b (surface/README 2.2), from sums of one order more.
template <class T, int P>
void centroidGradientSquare(const Moments<T, P>& m, Jet<T, P - 1> (&out)[6]) {
    const JetVec<T, P> c = m.q * inverse(m.one);
    JetVec<T, P - 1> row[3];
    for (std::size_t a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            row[a][static_cast<std::size_t>(b)] = derivative(c[a], b);
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b)
            out[sym(a, b)] = dot(row[a], row[b]);
}

} // namespace surface
