// The implicit functions of the frames, from the sums at a position and, where f is a height over a plane, its normal.
// Written with jets, so that gradient and Hessian are the exact derivatives. Shared by both precisions.
#pragma once

#include "core/surface/evaluation/frame_normal.h"
#include "core/surface/evaluation/moments.h"

namespace surface {

/// f with the normal of its tangent object: the plane, or the sphere at x. `cause` says why there is none.
template <class T, int O>
struct Field {
    Jet<T, O> f;
    JetVec<T, O> n{};
    Cause cause = Cause::None;
};

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

/// J J^T of the centroid's gradient J_ab = dc_a/dx_b (alg. 2.2, left convention), from sums of one order more.
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

/// Distance to the algebraic sphere u(y) = c0 + l.y + q |y|^2 that fits points and normals around x (alg. 10.3,
/// after Guennebaud & Gross 2007), with coordinates y at x. With U = u(x) and its gradient G on the sphere held still,
///     sign(q) (|x - b| - r) = 2 U / (|G| + sqrt(|G|^2 - 4 q U)),
/// which turns into the distance to a plane as q goes to zero. REQUIRES: points that are not all at one place.
template <class T, int O>
Field<T, O> sphereField(const Moments<T, O>& m, T beta) {
    const Jet<T, O> inverseWeight = inverse(m.one);
    const Jet<T, O> spread = m.square - dot(m.q, m.q) * inverseWeight;
    const Jet<T, O> q = (m.height - dot(m.q, m.n) * inverseWeight) * inverse(spread) * (T(0.5) * beta);
    JetVec<T, O> l, g;
    for (std::size_t a = 0; a < 3; ++a) {
        l[a] = (m.n[a] - m.q[a] * q * T(2)) * inverseWeight;
        g[a] = l[a] + timesCoordinate(static_cast<int>(a), q) * T(2);
    }
    Jet<T, O> u = -(dot(l, m.q) + q * m.square) * inverseWeight;
    for (int a = 0; a < 3; ++a)
        u += timesCoordinate(a, l[static_cast<std::size_t>(a)]) + timesCoordinate(a, timesCoordinate(a, q));
    const Jet<T, O> slopeSq = dot(g, g), normSq = slopeSq - q * u * T(4);
    Field<T, O> out;
    if (!(normSq.v > T(0))) { // the sphere is empty
        out.cause = Cause::CancellingNormals;
    } else if (!(slopeSq.v > T(1e-6) * normSq.v)) {
        out.cause = Cause::NoGradient;
    } else {
        const Jet<T, O> inverseSlope = inverseSqrt(slopeSq);
        out.f = u * inverse(slopeSq * inverseSlope + normSq * inverseSqrt(normSq)) * T(2);
        out.n = g * inverseSlope;
    }
    return out;
}

} // namespace surface
