#include "core/solid/loops/fairing.h"

#include "core/base/cancel_scope.h"

#include <Eigen/SparseCholesky>

namespace solid {

using base::Vec3d;
using Matrix = Eigen::SparseMatrix<double>;

/// Areas of triangles count as no less than so much of the sum of their sides' squares (0.14 where these are equal).
constexpr double thinnest = 0.02;

Measures::Measures(std::span<const Vec3d> x, std::span<const mesh::Triangle> triangles, double unit) {
    const auto n = static_cast<Eigen::Index>(x.size());
    areas = Eigen::VectorXd::Constant(n, 1e-3);
    std::vector<Eigen::Triplet<double>> entries;
    for (const mesh::Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<int>(t[k]), b = static_cast<int>(t[(k + 1) % 3]);
            const Vec3d c = x[t[(k + 2) % 3]], u = (x[t[k]] - c) / unit, v = (x[t[(k + 1) % 3]] - c) / unit;
            const double twice = length(cross(u, v));
            const double sides = lengthSq(u) + lengthSq(v) + lengthSq(u - v);
            const double weight = 0.5 * dot(u, v) / std::max({twice, 2 * thinnest * sides, 1e-12});
            entries.emplace_back(a, b, weight), entries.emplace_back(b, a, weight);
            areas[a] += twice / 6;
        }
    Matrix sums(n, n);
    sums.setFromTriplets(entries.begin(), entries.end());
    entries.clear();
    for (int column = 0; column < sums.outerSize(); ++column)
        for (Matrix::InnerIterator it(sums, column); it; ++it) {
            entries.emplace_back(it.row(), column, -it.value()), entries.emplace_back(column, column, it.value());
        }
    stiffness.resize(n, n);
    stiffness.setFromTriplets(entries.begin(), entries.end());
}

bool solve(const Measures& measures, std::span<const std::uint8_t> free, int order, Columns& values,
           const Columns* bend) {
    const auto applied = [&](const auto& to) { // stiffness per area, once more
        return (measures.stiffness * measures.areas.cwiseInverse().asDiagonal() * to).eval();
    };
    Matrix whole = measures.stiffness;
    Columns wanted = bend ? (measures.areas.asDiagonal() * *bend).eval() : Columns();
    for (int k = 1; k < order; ++k) {
        whole = applied(whole);
        if (bend)
            wanted = applied(wanted);
    }
    std::vector<int> place(free.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < free.size(); ++v)
        if (free[v])
            place[v] = count++;
    if (count == 0)
        return true;
    std::vector<Eigen::Triplet<double>> entries;
    Columns right = Columns::Zero(count, values.cols());
    for (std::size_t v = 0; bend && v < free.size(); ++v)
        if (free[v])
            right.row(place[v]) = wanted.row(static_cast<Eigen::Index>(v));
    for (int column = 0; column < whole.outerSize(); ++column)
        for (Matrix::InnerIterator it(whole, column); it; ++it) {
            const int row = place[static_cast<std::size_t>(it.row())], at = place[static_cast<std::size_t>(column)];
            if (row < 0)
                continue;
            if (at >= 0)
                entries.emplace_back(row, at, it.value());
            else
                right.row(row) -= it.value() * values.row(column);
        }
    Matrix system(count, count);
    system.setFromTriplets(entries.begin(), entries.end());
    base::CancelScope::check();
    const Eigen::SimplicialLDLT<Matrix> solver(system);
    if (solver.info() != Eigen::Success)
        return false;
    const Columns found = solver.solve(right);
    if (solver.info() != Eigen::Success || !found.allFinite())
        return false;
    for (std::size_t v = 0; v < free.size(); ++v)
        if (place[v] >= 0)
            values.row(static_cast<Eigen::Index>(v)) = found.row(place[v]);
    return true;
}

std::vector<Vec3d> vertexNormals(std::span<const Vec3d> x, std::span<const mesh::Triangle> triangles) {
    std::vector<Vec3d> out(x.size());
    for (const mesh::Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d u = x[t[(k + 1) % 3]] - x[t[k]], v = x[t[(k + 2) % 3]] - x[t[k]], n = cross(u, v);
            out[t[k]] += normalized(n) * std::atan2(length(n), dot(u, v));
        }
    for (Vec3d& n : out)
        n = normalized(n);
    return out;
}

} // namespace solid
