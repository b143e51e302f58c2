// 3x3 matrices for kernels, row-major: m[row][column]. Decompositions are Eigen's, which stays behind this header.
#pragma once

#include "core/base/vec.h"

namespace base {

template <class T>
struct Mat3 {
    T m[3][3]{};

    constexpr bool operator==(const Mat3&) const = default;
    constexpr T* operator[](int row) { return m[row]; }
    constexpr const T* operator[](int row) const { return m[row]; }

    static constexpr Mat3 identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
    constexpr Mat3& operator+=(const Mat3& o) {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                m[r][c] += o.m[r][c];
        return *this;
    }
    constexpr Mat3& operator*=(T s) {
        for (auto& row : m)
            for (auto& value : row)
                value *= s;
        return *this;
    }
};

using Mat3f = Mat3<float>;
using Mat3d = Mat3<double>;

template <class T>
constexpr Mat3<T> operator+(Mat3<T> a, const Mat3<T>& b) {
    return a += b;
}
template <class T>
constexpr Mat3<T> operator-(Mat3<T> a, Mat3<T> b) {
    return a += (b *= T(-1));
}
template <class T>
constexpr Mat3<T> operator*(Mat3<T> a, std::type_identity_t<T> s) {
    return a *= s;
}
template <class T>
constexpr Mat3<T> operator*(std::type_identity_t<T> s, Mat3<T> a) {
    return a *= s;
}
template <class T>
constexpr Vec3<T> operator*(const Mat3<T>& a, const Vec3<T>& v) {
    return {a[0][0] * v.x + a[0][1] * v.y + a[0][2] * v.z, a[1][0] * v.x + a[1][1] * v.y + a[1][2] * v.z,
            a[2][0] * v.x + a[2][1] * v.y + a[2][2] * v.z};
}
template <class T>
constexpr Mat3<T> operator*(const Mat3<T>& a, const Mat3<T>& b) {
    Mat3<T> out;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out[r][c] = a[r][0] * b[0][c] + a[r][1] * b[1][c] + a[r][2] * b[2][c];
    return out;
}
template <class T>
constexpr Mat3<T> transposed(const Mat3<T>& a) {
    return {{{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}}};
}
template <class T>
constexpr Mat3<T> outer(const Vec3<T>& a, const Vec3<T>& b) {
    return {{{a.x * b.x, a.x * b.y, a.x * b.z}, {a.y * b.x, a.y * b.y, a.y * b.z}, {a.z * b.x, a.z * b.y, a.z * b.z}}};
}
template <class T>
constexpr T trace(const Mat3<T>& a) {
    return a[0][0] + a[1][1] + a[2][2];
}
template <class T>
constexpr T determinant(const Mat3<T>& a) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/// Cofactor matrix: det(A) A^-T, defined for singular A too. Maps normals under the deformation A.
template <class T>
constexpr Mat3<T> cofactor(const Mat3<T>& a) {
    const Vec3<T> r0{a[0][0], a[0][1], a[0][2]}, r1{a[1][0], a[1][1], a[1][2]}, r2{a[2][0], a[2][1], a[2][2]};
    const Vec3<T> c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
    return {{{c0.x, c0.y, c0.z}, {c1.x, c1.y, c1.z}, {c2.x, c2.y, c2.z}}};
}

/// Eigenvalues in ascending order with their unit eigenvectors, a right-handed basis.
template <class T>
struct SymmetricEigen {
    T value[3]{};
    Vec3<T> vector[3]{};
};

/// By Eigen's iterative solver: as exact for close eigenvalues as for distant ones, where a closed form would lose half
/// the digits (base/README 3.1). REQUIRES: `a` symmetric; only its upper half is read. A matrix that is not finite has
/// the axes for vectors and its diagonal for values.
template <class T>
SymmetricEigen<T> symmetricEigen(const Mat3<T>& a);

/// A^-1. REQUIRES: not singular; the caller tests the determinant against its own scale.
template <class T>
Mat3<T> inverse(const Mat3<T>& a);

/// x with A x = b, for a positive definite A; only its upper half is read. Least squares with a ridge are such systems.
Vec3d solvePositive(const Mat3d& a, const Vec3d& b);

extern template SymmetricEigen<float> symmetricEigen(const Mat3<float>&);
extern template SymmetricEigen<double> symmetricEigen(const Mat3<double>&);
extern template Mat3<float> inverse(const Mat3<float>&);
extern template Mat3<double> inverse(const Mat3<double>&);

} // namespace base
