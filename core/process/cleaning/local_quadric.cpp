#include "core/process/cleaning/local_quadric.h"

#include "core/base/mat3.h"

#include <Eigen/Dense>

namespace process {

using base::Vec3d;

LocalFrame planeFrame(std::span<const base::Vec3f> positions, std::size_t i, std::span<const std::uint32_t> near,
                      const base::Vec3f& side) {
    const auto n = static_cast<double>(near.size() + 1);
    Vec3d mean;
    for (const std::uint32_t j : near)
        mean += base::cast<double>(positions[j] - positions[i]) / n;
    base::Mat3d c = base::outer(mean, mean);
    for (const std::uint32_t j : near) {
        const Vec3d q = base::cast<double>(positions[j] - positions[i]) - mean;
        c += base::outer(q, q);
    }
    const auto eigen = base::symmetricEigen(c);
    LocalFrame out{base::cast<double>(positions[i]), eigen.vector[1], eigen.vector[2], eigen.vector[0]};
    if (dot(out.n, base::cast<double>(side)) < 0)
        out.n = -out.n, out.v = -out.v;
    return out;
}

void QuadricSums::add(double x, double y, double z, double weight) {
    x *= m_scale, y *= m_scale;
    const double term[6] = {1, x, y, x * x, x * y, y * y};
    for (int r = 0; r < 6; ++r) {
        for (int c = r; c < 6; ++c)
            m_normal[r][c] += weight * term[r] * term[c];
        m_right[r] += weight * term[r] * z;
    }
    m_samples += weight > 0 ? 1 : 0;
}

void QuadricSums::add(const LocalFrame& frame, const base::Vec3f& p, double weight) {
    const Vec3d q = base::cast<double>(p) - frame.origin;
    add(dot(q, frame.u), dot(q, frame.v), dot(q, frame.n), weight);
}

/// The first `N` terms; false where the samples do not determine them.
template <int N>
static bool solve(const double (&normal)[6][6], const double (&right)[6], double scale, QuadricFit& out) {
    constexpr double leastPivot = 1e-9;
    Eigen::Matrix<double, N, N> a;
    Eigen::Matrix<double, N, 1> b, first = Eigen::Matrix<double, N, 1>::Unit(0);
    for (int r = 0; r < N; ++r) {
        b(r) = right[r];
        for (int c = 0; c < N; ++c)
            a(r, c) = r <= c ? normal[r][c] : normal[c][r];
    }
    const Eigen::LDLT<Eigen::Matrix<double, N, N>> ldlt(a);
    const auto pivots = ldlt.vectorD();
    if (!(pivots.minCoeff() > leastPivot * pivots.maxCoeff()))
        return false;
    const Eigen::Matrix<double, N, 1> x = ldlt.solve(b);
    out.terms = N;
    const double unit[6] = {1, scale, scale, scale * scale, scale * scale, scale * scale};
    for (int r = 0; r < N; ++r)
        out.c[r] = x(r) * unit[r];
    out.variance = ldlt.solve(first)(0);
    return true;
}

QuadricFit QuadricSums::fit() const {
    constexpr double spareSamples = 2;
    QuadricFit out;
    if (m_samples >= 6 + spareSamples && solve<6>(m_normal, m_right, m_scale, out))
        return out;
    if (m_samples >= 3 + spareSamples && solve<3>(m_normal, m_right, m_scale, out))
        return out;
    if (m_normal[0][0] > 0) {
        out.terms = 1;
        out.c[0] = m_right[0] / m_normal[0][0];
        out.variance = 1 / m_normal[0][0];
    }
    return out;
}

} // namespace process
