// One step towards a foot (surface/README 3.2): the plain image of an iterate under its projector, and from it a faster
// step that stays in the same basin.
//
// At an iterate y with the plane's direction v (the gradient g for orthogonal projections, the frame normal n for the
// others) the plain image is
//
//     T(y) = b - s v,   s = (f + l.(b - y)) / (l.v)        b = x0, or y for basic ones; l = g where known, else n
//
// so that l.(T(y) - y) = -f: T lands on the plane that f is at y. Along the surface T multiplies errors by -s Dv; with
// r = T(y) - y and W = I + s Dv the foot lies about W^-1 r away. `guarded` takes that step with an estimate of Dv,
// `newton` with Dv itself, where the system for (y, s) is
//
//     (I + s Dv) dy + v ds = r,   l.dy = -f                    (surface/README 3.2)
//
// The guard: the fixed point of a map that contracts by q = 1 - w lies within q/(1-q) of a step beyond its image. W's
// eigenvalues along the surface therefore count as 1/2 or more while Dv is only estimated or the step is long: the step
// is at most twice the plain one. Where W has negative eigenvalues (a saddle, a farthest point) the step follows the
// plain one away from there.
#pragma once

#include "core/surface/surface.h"

#include <algorithm>

namespace surface {

/// What a step needs to know of an iterate y.
template <class T>
struct Iterate {
    base::Vec3<T> back;  ///< b - y
    base::Vec3<T> along; ///< v
    base::Vec3<T> slope; ///< l
    T value = 0;         ///< f
    T unit = 0;          ///< h
    T parts = 0;         ///< s: b is s v above the plane

    /// REQUIRES: along, slope, back and value are set; l.v != 0.
    void meet() { parts = (value + dot(slope, back)) / dot(slope, along); }
    base::Vec3<T> plain() const { return back - along * parts; }
};

/// A symmetric matrix on the plane across a unit vector.
template <class T>
class TangentMatrix {
  public:
    explicit TangentMatrix(const base::Vec3<T>& normal) : m_u(base::perpendicular(normal)), m_v(cross(normal, m_u)) {}

    /// Adds the symmetric part of `a`, restricted to the plane.
    void add(const base::Mat3<T>& a, T factor) {
        const base::Vec3<T> au = a * m_u, av = a * m_v;
        m_uu += factor * dot(m_u, au);
        m_uv += factor * T(0.5) * (dot(m_u, av) + dot(m_v, au));
        m_vv += factor * dot(m_v, av);
    }

    /// The least change that maps s to z and keeps the matrix symmetric [Powell70].
    void learn(const base::Vec3<T>& s, const base::Vec3<T>& z) {
        const T su = dot(s, m_u), sv = dot(s, m_v), square = su * su + sv * sv;
        if (!(square > T(0)))
            return;
        const T eu = dot(z, m_u) - (m_uu * su + m_uv * sv), ev = dot(z, m_v) - (m_uv * su + m_vv * sv);
        const T both = (eu * su + ev * sv) / square;
        m_uu += (T(2) * eu * su - both * su * su) / square;
        m_uv += (eu * sv + ev * su - both * su * sv) / square;
        m_vv += (T(2) * ev * sv - both * sv * sv) / square;
    }

    T smallest() const { return T(0.5) * (m_uu + m_vv) - radius(); }

    /// The inverse times r, with all eigenvalues taken as `least` or more.
    base::Vec3<T> solve(const base::Vec3<T>& r, T least) const {
        const T ru = dot(r, m_u), rv = dot(r, m_v), spread = radius(), mean = T(0.5) * (m_uu + m_vv);
        const T small = T(1) / std::max(mean - spread, least), large = T(1) / std::max(mean + spread, least);
        if (!(spread > T(0)))
            return (m_u * ru + m_v * rv) * small;
        // I/2 + [half, uv; uv, -half] / (2 spread) projects on the larger eigenvector
        const T half = T(0.5) * (m_uu - m_vv);
        const T lu = T(0.5) * (ru + (half * ru + m_uv * rv) / spread);
        const T lv = T(0.5) * (rv + (m_uv * ru - half * rv) / spread);
        return m_u * (large * lu + small * (ru - lu)) + m_v * (large * lv + small * (rv - lv));
    }

  private:
    T radius() const {
        const T half = T(0.5) * (m_uu - m_vv);
        return std::sqrt(half * half + m_uv * m_uv);
    }

    base::Vec3<T> m_u, m_v;
    T m_uu = 1, m_uv = 0, m_vv = 1;
};

constexpr double leastEstimated = 0.5; ///< of W's eigenvalues, while Dv is estimated or the step is long
constexpr double leastExact = 0.05;    ///< with Dv itself and a short step
constexpr double shortStep = 0.1;      ///< in units of h
constexpr double smallBend = 0.2;      ///< |s Dv| up to which a series does
constexpr double longestStep = 0.5;    ///< along the surface, in units of h
/// Above near sheets, where the farther one comes into play, f is flatter than on the way to the surface: from so many
/// h on, with a slope along n below that.
constexpr double fadesFrom = 0.25, fadesBelow = 0.85;

/// r across the plane plus `inverse` of r along it, which is W^-1 r by some estimate of W.
template <class T, class Inverse>
base::Vec3<T> guardedBy(const Iterate<T>& at, const Inverse& inverse) {
    const base::Vec3<T> r = at.plain();
    const base::Vec3<T> across = at.along * (dot(at.along, r) / lengthSq(at.along));
    const base::Vec3<T> p = inverse(r - across);
    const T square = lengthSq(p), reach = T(longestStep) * at.unit;
    return across + (square > reach * reach ? p * (reach / std::sqrt(square)) : p);
}
template <class T>
base::Vec3<T> guarded(const Iterate<T>& at, const TangentMatrix<T>& w) {
    return guardedBy(at, [&](const base::Vec3<T>& r) { return w.solve(r, T(leastEstimated)); });
}
/// Nothing is known of W.
template <class T>
base::Vec3<T> guarded(const Iterate<T>& at) {
    return guardedBy(at, [](const base::Vec3<T>& r) { return r; });
}

/// The same where s Dv is small, W^-1 by its series: three terms leave an error of smallBend^3. False where it is not.
template <class T>
bool guardedBySeries(const Iterate<T>& at, const base::Mat3<T>& dv, T factor, base::Vec3<T>& out) {
    const T s = at.parts * factor;
    T square = 0;
    for (const auto& row : dv.m)
        square += row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
    if (!(s * s * square <= T(smallBend * smallBend)))
        return false;
    const base::Vec3<T> r = at.plain();
    const T inverse = T(1) / lengthSq(at.along);
    const auto tangential = [&](const base::Vec3<T>& v) { return v - at.along * (dot(at.along, v) * inverse); };
    const base::Vec3<T> t = tangential(r), once = tangential(dv * t) * s, twice = tangential(dv * once) * s;
    const base::Vec3<T> p = t - once + twice;
    if (!(lengthSq(p) <= T(longestStep * longestStep) * at.unit * at.unit))
        return false;
    out = r - t + p;
    return true;
}

/// Newton's step with Dv, or zero where the guard forbids it.
template <class T>
base::Vec3<T> newton(const Iterate<T>& at, const base::Mat3<T>& dv) {
    const base::Vec3<T> r = at.plain();
    TangentMatrix<T> w(base::normalized(at.along));
    w.add(dv, at.parts);
    const bool brief = length(r) < T(shortStep) * at.unit;
    if (!(w.smallest() > T(brief ? leastExact : leastEstimated)))
        return {};
    const base::Mat3<T> a = base::Mat3<T>::identity() + dv * at.parts;
    const base::Mat3<T> back = inverse(a);
    const base::Vec3<T> ar = back * r, av = back * at.along;
    const base::Vec3<T> out = ar - av * ((dot(at.slope, ar) + at.value) / dot(at.slope, av));
    return lengthSq(out) <= T(longestStep * longestStep) * at.unit * at.unit ? out : base::Vec3<T>{};
}

} // namespace surface
