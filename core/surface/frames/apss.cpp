// Algebraic point set surfaces [Guennebaud07]: the distance to the algebraic sphere u(y) = c0 + l.y + q |y|^2 that fits
// points and normals around x, with coordinates y at x (surface/README 2.8).
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

template <class T, int O>
struct Sphere {
    Jet<T, O> u; ///< at x
    JetVec<T, O> l, gradient;
    Jet<T, O> q;
};

template <class T, int O>
Sphere<T, O> fittedSphere(const Moments<T, O>& m, T beta) {
    Sphere<T, O> out;
    const Jet<T, O> inverseWeight = inverse(m.one);
    const Jet<T, O> spread = m.square - dot(m.q, m.q) * inverseWeight;
    out.q = (m.height - dot(m.q, m.n) * inverseWeight) * inverse(spread) * (T(0.5) * beta);
    for (std::size_t a = 0; a < 3; ++a) {
        out.l[a] = (m.n[a] - m.q[a] * out.q * T(2)) * inverseWeight;
        out.gradient[a] = out.l[a] + timesCoordinate(static_cast<int>(a), out.q) * T(2);
    }
    out.u = -(dot(out.l, m.q) + out.q * m.square) * inverseWeight;
    for (int a = 0; a < 3; ++a)
        out.u += timesCoordinate(a, out.l[static_cast<std::size_t>(a)]) + timesCoordinate(a, timesCoordinate(a, out.q));
    return out;
}

struct Apss {
    /// With U = u(x), its gradient G, and the sphere held still, the distance is
    ///     sign(q) (|x - b| - r) = 2 U / (|G| + sqrt(|G|^2 - 4 q U)),
    /// which turns into that to a plane as q goes to zero. REQUIRES: points that are not all at one place.
    template <class T, int O>
    static Field<T, O> field(const Neighbourhood<T, O>& at) {
        const Sphere<T, O> sphere = fittedSphere(at.moments, static_cast<T>(at.definition().apssBeta));
        const Jet<T, O> slopeSq = dot(sphere.gradient, sphere.gradient);
        const Jet<T, O> normSq = slopeSq - sphere.q * sphere.u * T(4);
        if (!(normSq.v > T(0))) // the sphere is empty
            return {{}, {}, Cause::CancellingNormals};
        if (!(slopeSq.v > T(1e-6) * normSq.v))
            return {{}, {}, Cause::NoGradient};
        const Jet<T, O> inverseSlope = inverseSqrt(slopeSq);
        return {sphere.u * inverse(slopeSq * inverseSlope + normSq * inverseSqrt(normSq)) * T(2),
                sphere.gradient * inverseSlope, Cause::None};
    }
};

} // namespace

constinit const FramePart ApssPart = framePart<Apss>();

} // namespace surface
