// Points and vectors of three components, in float (storage, fast paths) and double (reference, import).
// Plain values without invariants. Lengths are in model units unless a name says otherwise.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace base {

template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    constexpr T& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
    constexpr Vec3& operator+=(const Vec3& o) { return x += o.x, y += o.y, z += o.z, *this; }
    constexpr Vec3& operator-=(const Vec3& o) { return x -= o.x, y -= o.y, z -= o.z, *this; }
    constexpr Vec3& operator*=(T s) { return x *= s, y *= s, z *= s, *this; }
    constexpr bool operator==(const Vec3&) const = default;
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class T>
constexpr Vec3<T> operator+(Vec3<T> a, const Vec3<T>& b) {
    return a += b;
}
template <class T>
constexpr Vec3<T> operator-(Vec3<T> a, const Vec3<T>& b) {
    return a -= b;
}
template <class T>
constexpr Vec3<T> operator-(const Vec3<T>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class T>
constexpr Vec3<T> operator*(Vec3<T> a, std::type_identity_t<T> s) {
    return a *= s;
}
template <class T>
constexpr Vec3<T> operator*(std::type_identity_t<T> s, Vec3<T> a) {
    return a *= s;
}
template <class T>
constexpr Vec3<T> operator/(const Vec3<T>& a, std::type_identity_t<T> s) {
    return {a.x / s, a.y / s, a.z / s};
}

template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
constexpr T lengthSq(const Vec3<T>& a) {
    return dot(a, a);
}
template <class T>
T length(const Vec3<T>& a) {
    return std::sqrt(dot(a, a));
}
template <class T>
constexpr T distanceSq(const Vec3<T>& a, const Vec3<T>& b) {
    return lengthSq(a - b);
}
template <class T>
T distance(const Vec3<T>& a, const Vec3<T>& b) {
    return length(a - b);
}

/// Unit vector along `a`, or `otherwise` where `a` has no direction (zero or not finite).
template <class T>
Vec3<T> normalized(const Vec3<T>& a, const Vec3<T>& otherwise = {}) {
    const T l = length(a);
    return l > T(0) && std::isfinite(l) ? a / l : otherwise;
}

/// Some unit vector perpendicular to the unit vector `n`, continuous except at one pole (Duff et al. 2017).
template <class T>
Vec3<T> perpendicular(const Vec3<T>& n) {
    const T sign = std::copysign(T(1), n.z);
    const T a = T(-1) / (sign + n.z);
    return {T(1) + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

template <class T>
bool isFinite(const Vec3<T>& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Component-wise conversion; the only way from one precision to the other.
template <class To, class From>
constexpr Vec3<To> cast(const Vec3<From>& a) {
    return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

} // namespace base
