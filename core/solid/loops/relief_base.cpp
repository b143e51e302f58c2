#include "core/solid/loops/relief_base.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>

namespace solid {

using base::Vec3d;

HoleMap::HoleMap(const Vec3d& middle, const Vec3d& normal) : m_middle(middle), m_normal(normal) {
    const Vec3d axis = std::abs(normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    m_u = normalized(cross(axis, normal));
    m_v = cross(normal, m_u);
}

MapPlace HoleMap::at(const Vec3d& x, const Vec3d& normal) const {
    const Vec3d to = x - m_middle;
    const double u = dot(to, m_u), v = dot(to, m_v), across = std::hypot(u, v);
    if (!(across > 0))
        return {};
    // a chord over an arc that turns by that angle
    const double half = 0.5 * std::acos(std::clamp(dot(normal, m_normal), -1.0, 1.0));
    const double way = length(to) * (half > 1e-4 ? half / std::sin(half) : 1);
    return {u * way / across, v * way / across};
}

HoleMap mapOver(const Patch& patch, const std::vector<Vec3d>& normals) {
    Vec3d middle;
    for (const Vec3d& p : patch.positions)
        middle += p / static_cast<double>(patch.positions.size());
    std::size_t nearest = 0;
    for (std::size_t v = 0; v < patch.positions.size(); ++v)
        if (lengthSq(patch.positions[v] - middle) < lengthSq(patch.positions[nearest] - middle))
            nearest = v;
    Vec3d normal;
    for (const Vec3d& n : normals)
        normal += n;
    return {patch.positions[nearest], normalized(normal, normals[nearest])};
}

/// u^i v^j of all degrees up to that one, or their derivative along u or v.
static std::vector<double> powers(double u, double v, int degree, int along = -1) {
    std::vector<double> out;
    for (int sum = 0; sum <= degree; ++sum)
        for (int j = 0; j <= sum; ++j) {
            const int i = sum - j;
            const auto power = [](double x, int n) { return n < 0 ? 0 : std::pow(x, n); };
            out.push_back(along == 0   ? i * power(u, i - 1) * power(v, j)
                          : along == 1 ? j * power(u, i) * power(v, j - 1)
                                       : power(u, i) * power(v, j));
        }
    return out;
}

ReliefBase::ReliefBase(std::span<const Vec3d> positions, std::span<const MapPlace> places, int degree)
    : m_degree(degree), m_scale(1e-30) {
    for (const MapPlace& p : places)
        m_scale = std::max({m_scale, std::abs(p.u), std::abs(p.v)});
    m_origin = positions.empty() ? Vec3d() : positions[0];
    const auto count = static_cast<Eigen::Index>((m_degree + 1) * (m_degree + 2) / 2);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(count, count) * 1e-9, right = Eigen::MatrixXd::Zero(count, 3);
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const std::vector<double> p = powers(places[k].u / m_scale, places[k].v / m_scale, m_degree);
        const Eigen::Map<const Eigen::VectorXd> row(p.data(), count);
        const Vec3d x = positions[k] - m_origin;
        normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
        right += row * Eigen::RowVector3d(x.x, x.y, x.z);
    }
    const Eigen::MatrixXd found = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    for (Eigen::Index i = 0; i < count; ++i)
        m_factors.push_back({found(i, 0), found(i, 1), found(i, 2)});
}

static Vec3d summed(const std::vector<Vec3d>& factors, const std::vector<double>& powers) {
    Vec3d out;
    for (std::size_t i = 0; i < factors.size(); ++i)
        out += factors[i] * powers[i];
    return out;
}

Vec3d ReliefBase::at(const MapPlace& p) const {
    return m_origin + summed(m_factors, powers(p.u / m_scale, p.v / m_scale, m_degree));
}

Vec3d ReliefBase::normal(const MapPlace& p) const {
    return normalized(cross(along(p, true), along(p, false)));
}

Vec3d ReliefBase::along(const MapPlace& p, bool u) const {
    return normalized(summed(m_factors, powers(p.u / m_scale, p.v / m_scale, m_degree, u ? 0 : 1)));
}

} // namespace solid
