// Jets: a value with its derivatives in x up to an order, and arithmetic that carries them along (forward automatic
// differentiation). Formulas written once with jets give f, its gradient and its Hessian; order 0 costs a plain number.
#pragma once

#include "core/base/mat3.h"
#include "core/surface/evaluation/jet_lanes.h"

#include <algorithm>
#include <array>

namespace surface {

/// Place of the (k, l) entry of a symmetric 3x3 matrix among its six: 00 01 02 11 12 22.
constexpr int sym(int k, int l) {
    return k <= l ? k * (5 - k) / 2 + l : l * (5 - l) / 2 + k;
}

/// Place of the (j, k, l) entry of a symmetric 3x3x3 tensor among its ten: 000 001 002 011 012 022 111 112 122 222.
constexpr int sym(int j, int k, int l) {
    const int least = std::min({j, k, l}), most = std::max({j, k, l}), middle = j + k + l - least - most;
    return least == 0 ? sym(middle, most) : least == 1 ? 4 + middle + most : 9;
}

/// fn(j, k, l) for the ten entries j <= k <= l of such a tensor.
template <class Fn>
constexpr void forTriples(const Fn& fn) {
    for (int j = 0; j < 3; ++j)
        for (int k = j; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                fn(j, k, l);
}

/// What a jet has of the derivatives beyond its order: takes no room, where each is a type of its own.
template <class T, int which>
struct NoNumbers {
    static constexpr std::size_t size() { return 0; }
    T* begin() { return nullptr; }
    T* end() { return nullptr; }
    const T* begin() const { return nullptr; }
    const T* end() const { return nullptr; }
    T& operator[](std::size_t) { return *begin(); }
    const T& operator[](std::size_t) const { return *begin(); }
};
template <class T, int which, std::size_t n>
using Numbers = std::conditional_t<n == 0, NoNumbers<T, which>, std::array<T, n>>;

/// Orders up to 3. Third derivatives are there for frames that read one derivative of the weights themselves.
template <class T, int Order>
struct alignas(inRegisters<T, Order> ? 16 : alignof(T)) Jet {
    static_assert(Order >= 0 && Order <= 3);
    T v{};
    [[no_unique_address]] Numbers<T, 1, Order >= 1 ? 3 : 0> d{};    ///< first derivatives
    [[no_unique_address]] Numbers<T, 2, Order >= 2 ? 6 : 0> dd{};   ///< second derivatives, by `sym`
    [[no_unique_address]] Numbers<T, 3, Order >= 3 ? 10 : 0> ddd{}; ///< third derivatives, by `sym`
    /// Fills the registers, with zeros.
    [[no_unique_address]] Numbers<T, 0, inRegisters<T, Order> && Order == 2 ? 2 : 0> unused{};

    Jet& operator+=(const Jet& o) {
        if constexpr (inRegisters<T, Order>)
            return *this = jet_lanes::add(*this, o);
        v += o.v;
        for (std::size_t k = 0; k < d.size(); ++k)
            d[k] += o.d[k];
        for (std::size_t k = 0; k < dd.size(); ++k)
            dd[k] += o.dd[k];
        for (std::size_t k = 0; k < ddd.size(); ++k)
            ddd[k] += o.ddd[k];
        return *this;
    }
    Jet& operator*=(T s) {
        if constexpr (inRegisters<T, Order>)
            return *this = jet_lanes::scale(*this, s);
        v *= s;
        for (auto& each : d)
            each *= s;
        for (auto& each : dd)
            each *= s;
        for (auto& each : ddd)
            each *= s;
        return *this;
    }
};

template <class T, int O>
Jet<T, O> operator+(Jet<T, O> a, const Jet<T, O>& b) {
    return a += b;
}
template <class T, int O>
Jet<T, O> operator*(Jet<T, O> a, std::type_identity_t<T> s) {
    return a *= s;
}
template <class T, int O>
Jet<T, O> operator-(const Jet<T, O>& a) {
    return a * T(-1);
}
template <class T, int O>
Jet<T, O> operator-(const Jet<T, O>& a, const Jet<T, O>& b) {
    if constexpr (inRegisters<T, O>)
        return jet_lanes::subtract(a, b);
    Jet<T, O> out = a;
    out.v -= b.v;
    for (std::size_t k = 0; k < out.d.size(); ++k)
        out.d[k] -= b.d[k];
    for (std::size_t k = 0; k < out.dd.size(); ++k)
        out.dd[k] -= b.dd[k];
    for (std::size_t k = 0; k < out.ddd.size(); ++k)
        out.ddd[k] -= b.ddd[k];
    return out;
}

template <class T, int O>
Jet<T, O> operator*(const Jet<T, O>& a, const Jet<T, O>& b) {
    if constexpr (inRegisters<T, O>)
        return jet_lanes::multiply(a, b);
    Jet<T, O> out;
    out.v = a.v * b.v;
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k)
            out.d[k] = a.d[k] * b.v + a.v * b.d[k];
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                out.dd[sym(k, l)] = a.dd[sym(k, l)] * b.v + a.d[k] * b.d[l] + a.d[l] * b.d[k] + a.v * b.dd[sym(k, l)];
    if constexpr (O >= 3)
        forTriples([&](int j, int k, int l) {
            out.ddd[sym(j, k, l)] = a.ddd[sym(j, k, l)] * b.v + a.dd[sym(j, k)] * b.d[l] + a.dd[sym(j, l)] * b.d[k] +
                                    a.dd[sym(k, l)] * b.d[j] + a.d[j] * b.dd[sym(k, l)] + a.d[k] * b.dd[sym(j, l)] +
                                    a.d[l] * b.dd[sym(j, k)] + a.v * b.ddd[sym(j, k, l)];
        });
    return out;
}

/// A function of a jet by its value and derivatives at a.v.
template <class T, int O>
Jet<T, O> chain(const Jet<T, O>& a, T f0, [[maybe_unused]] T f1, [[maybe_unused]] T f2, [[maybe_unused]] T f3) {
    if constexpr (inRegisters<T, O>)
        return jet_lanes::chain(a, f0, f1, f2);
    Jet<T, O> out;
    out.v = f0;
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k)
            out.d[k] = f1 * a.d[k];
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                out.dd[sym(k, l)] = f1 * a.dd[sym(k, l)] + f2 * a.d[k] * a.d[l];
    if constexpr (O >= 3)
        forTriples([&](int j, int k, int l) {
            out.ddd[sym(j, k, l)] =
                f1 * a.ddd[sym(j, k, l)] +
                f2 * (a.dd[sym(j, k)] * a.d[l] + a.dd[sym(j, l)] * a.d[k] + a.dd[sym(k, l)] * a.d[j]) +
                f3 * a.d[j] * a.d[k] * a.d[l];
        });
    return out;
}

/// 1 / a. REQUIRES: a.v != 0.
template <class T, int O>
Jet<T, O> inverse(const Jet<T, O>& a) {
    const T i = T(1) / a.v;
    return chain(a, i, -i * i, T(2) * i * i * i, T(-6) * i * i * i * i);
}

/// 1 / sqrt(a). REQUIRES: a.v > 0.
template <class T, int O>
Jet<T, O> inverseSqrt(const Jet<T, O>& a) {
    const T i = T(1) / a.v, s = std::sqrt(i);
    return chain(a, s, T(-0.5) * s * i, T(0.75) * s * i * i, T(-1.875) * s * i * i * i);
}

/// The first derivative by x_k, a jet of one order less.
template <class T, int O>
Jet<T, O - 1> derivative(const Jet<T, O>& a, int k) {
    Jet<T, O - 1> out;
    out.v = a.d[k];
    if constexpr (O >= 2)
        for (int l = 0; l < 3; ++l)
            out.d[l] = a.dd[sym(k, l)];
    if constexpr (O >= 3)
        for (int l = 0; l < 3; ++l)
            for (int m = l; m < 3; ++m)
                out.dd[sym(l, m)] = a.ddd[sym(k, l, m)];
    return out;
}

/// The same without the derivatives beyond order P.
template <int P, class T, int O>
Jet<T, P> truncated(const Jet<T, O>& a) {
    static_assert(P <= O);
    Jet<T, P> out;
    out.v = a.v;
    std::copy_n(a.d.begin(), out.d.size(), out.d.begin());
    std::copy_n(a.dd.begin(), out.dd.size(), out.dd.begin());
    std::copy_n(a.ddd.begin(), out.ddd.size(), out.ddd.begin());
    return out;
}

/// a times the coordinate x_axis - x0_axis, at x = x0: the value is zero, the derivatives are not.
template <class T, int O>
Jet<T, O> timesCoordinate(int axis, [[maybe_unused]] const Jet<T, O>& a) {
    if constexpr (inRegisters<T, O>)
        return jet_lanes::timesCoordinate(axis, a);
    Jet<T, O> out;
    if constexpr (O >= 1)
        out.d[axis] = a.v;
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            out.dd[sym(axis, k)] += a.d[k] * T(k == axis ? 2 : 1);
    static_assert(O <= 2);
    return out;
}

/// A number that stays as it is while x moves.
template <class T, int O>
Jet<T, O> constantJet(std::type_identity_t<T> value) {
    if constexpr (inRegisters<T, O>)
        return jet_lanes::jet<O>(Four{value, 0, 0, 0});
    Jet<T, O> out;
    out.v = value;
    return out;
}
/// The coordinate x_axis - x0_axis itself, at x = x0.
template <class T, int O>
Jet<T, O> coordinate(int axis) {
    return timesCoordinate(axis, constantJet<T, O>(1));
}

template <class T, int O>
using JetVec = std::array<Jet<T, O>, 3>;

template <class T, int O>
base::Vec3<T> valueOf(const JetVec<T, O>& a) {
    return {a[0].v, a[1].v, a[2].v};
}
template <class T, int O>
Jet<T, O> dot(const JetVec<T, O>& a, const JetVec<T, O>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T, int O>
JetVec<T, O> operator*(const JetVec<T, O>& a, const Jet<T, O>& s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
template <class T, int O>
JetVec<T, O> operator*(const JetVec<T, O>& a, std::type_identity_t<T> s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}

/// The jet of x -> a(y(x)), where `a` holds derivatives in y at y(x).
template <class T, int O>
Jet<T, O> compose(const Jet<T, O>& a, [[maybe_unused]] const JetVec<T, O>& y) {
    static_assert(O <= 2);
    Jet<T, O> out;
    out.v = a.v;
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k)
            for (int b = 0; b < 3; ++b)
                out.d[k] += a.d[b] * y[b].d[k];
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                for (int b = 0; b < 3; ++b) {
                    out.dd[sym(k, l)] += a.d[b] * y[b].dd[sym(k, l)];
                    for (int c = 0; c < 3; ++c)
                        out.dd[sym(k, l)] += a.dd[sym(b, c)] * y[b].d[k] * y[c].d[l];
                }
    return out;
}

} // namespace surface
