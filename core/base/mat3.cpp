#include "core/base/mat3.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <utility>

namespace base {

template <class T>
static Eigen::Matrix<T, 3, 3> eigenOf(const Mat3<T>& a) {
    return Eigen::Map<const Eigen::Matrix<T, 3, 3, Eigen::RowMajor>>(&a.m[0][0]);
}

/// Ascending; `columns` are the vectors.
template <class T>
static SymmetricEigen<T> ascending(const Eigen::Matrix<T, 3, 1>& values, const Eigen::Matrix<T, 3, 3>& columns) {
    SymmetricEigen<T> out;
    for (int k = 0; k < 3; ++k) {
        out.value[k] = values[k];
        out.vector[k] = {columns(0, k), columns(1, k), columns(2, k)};
    }
    if (dot(cross(out.vector[0], out.vector[1]), out.vector[2]) < T(0))
        out.vector[2] = -out.vector[2];
    return out;
}

template <class T>
SymmetricEigen<T> symmetricEigen(const Mat3<T>& a) {
    const Eigen::Matrix<T, 3, 3> m = eigenOf(a).transpose(); // Eigen reads the lower half
    if (!m.allFinite())
        return ascending<T>(m.diagonal(), Eigen::Matrix<T, 3, 3>::Identity());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<T, 3, 3>> solver(m);
    return ascending<T>(solver.eigenvalues(), solver.eigenvectors());
}

template <class T>
Mat3<T> inverse(const Mat3<T>& a) {
    Mat3<T> out;
    Eigen::Map<Eigen::Matrix<T, 3, 3, Eigen::RowMajor>>(&out.m[0][0]) = eigenOf(a).inverse();
    return out;
}

Vec3d solvePositive(const Mat3d& a, const Vec3d& b) {
    const Eigen::Vector3d x = eigenOf(a).transpose().ldlt().solve(Eigen::Vector3d(b.x, b.y, b.z));
    return {x[0], x[1], x[2]};
}

template SymmetricEigen<float> symmetricEigen(const Mat3<float>&);
template SymmetricEigen<double> symmetricEigen(const Mat3<double>&);
template Mat3<float> inverse(const Mat3<float>&);
template Mat3<double> inverse(const Mat3<double>&);

} // namespace base
