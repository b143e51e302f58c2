#include "core/base/mat3.h"

#include <limits>
#include <utility>

namespace base {

/// One Jacobi rotation that zeroes a[p][q] (Golub & Van Loan, 8.5.2), accumulated in the columns of `v`.
template <class T>
static void rotate(Mat3<T>& a, Mat3<T>& v, int p, int q) {
    if (a[p][q] == T(0))
        return;
    const T theta = (a[q][q] - a[p][p]) / (T(2) * a[p][q]);
    const T t = std::copysign(T(1), theta) / (std::abs(theta) + std::sqrt(theta * theta + T(1)));
    const T c = T(1) / std::sqrt(t * t + T(1));
    const T s = t * c;
    const int r = 3 - p - q;
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = T(0);
    const T rp = a[r][p], rq = a[r][q];
    a[r][p] = a[p][r] = c * rp - s * rq;
    a[r][q] = a[q][r] = s * rp + c * rq;
    for (int k = 0; k < 3; ++k) {
        const T kp = v[k][p], kq = v[k][q];
        v[k][p] = c * kp - s * kq;
        v[k][q] = s * kp + c * kq;
    }
}

template <class T>
SymmetricEigen<T> symmetricEigen(const Mat3<T>& input) {
    Mat3<T> a = input;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < r; ++c)
            a[r][c] = a[c][r];
    T scale = T(0);
    for (const auto& row : a.m)
        for (T value : row)
            scale = std::max(scale, std::abs(value));
    Mat3<T> v = Mat3<T>::identity();
    if (scale > T(0) && std::isfinite(scale)) {
        a *= T(1) / scale;
        for (int sweep = 0; sweep < 12; ++sweep) {
            if (std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]) < std::numeric_limits<T>::min())
                break;
            rotate(a, v, 0, 1);
            rotate(a, v, 0, 2);
            rotate(a, v, 1, 2);
        }
    }
    int order[3] = {0, 1, 2};
    const auto swapIfGreater = [&](int i, int j) {
        if (a[order[i]][order[i]] > a[order[j]][order[j]])
            std::swap(order[i], order[j]);
    };
    swapIfGreater(0, 1);
    swapIfGreater(1, 2);
    swapIfGreater(0, 1);
    SymmetricEigen<T> out;
    for (int k = 0; k < 3; ++k) {
        out.value[k] = a[order[k]][order[k]] * scale;
        out.vector[k] = {v[0][order[k]], v[1][order[k]], v[2][order[k]]};
    }
    if (dot(cross(out.vector[0], out.vector[1]), out.vector[2]) < T(0))
        out.vector[2] = -out.vector[2];
    return out;
}

template SymmetricEigen<float> symmetricEigen(const Mat3<float>&);
template SymmetricEigen<double> symmetricEigen(const Mat3<double>&);

} // namespace base
