#include "core/render/splats/smooth_patch.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>

namespace render {

namespace {

using base::Vec3d;

/// A foot's normal leans by less from that of the middle, as a cosine.
constexpr double leastCosine = 0.34;
/// How far from a foot its slope still tells the height, in radii: half the way to the next.
constexpr double slopeReach = 0.375;
/// Added to the diagonal, times its mean: feet may lie so that a term is hardly known.
constexpr double damping = 1e-9;

} // namespace

std::array<SmoothPatch::Row, 3> SmoothPatch::rowsAt(double a, double b) {
    return {Row{1, a, b, a * a, a * b, b * b, a * a * a, a * a * b, a * b * b, b * b * b},
            Row{0, 1, 0, 2 * a, b, 0, 3 * a * a, 2 * a * b, b * b, 0},
            Row{0, 0, 1, 0, a, 2 * b, 0, a * a, 2 * a * b, 3 * b * b}};
}

SmoothPatch::Height SmoothPatch::heightAt(double a, double b) const {
    std::array<double, 3> out{};
    const auto rows = rowsAt(a, b);
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t k = 0; k < terms; ++k)
            out[r] += rows[r][k] * m_factors[k];
    return {out[0], out[1], out[2]};
}

std::optional<SmoothPatch> SmoothPatch::through(std::span<const Foot> feet, float radius, float most) {
    SmoothPatch out;
    out.m_middle = base::cast<double>(feet.front().position);
    out.m_normal = base::cast<double>(feet.front().normal);
    out.m_u = base::perpendicular(out.m_normal);
    out.m_v = cross(out.m_normal, out.m_u);
    out.m_radius = double(radius);
    struct Known {
        double a, b;
        std::array<double, 3> told; ///< height, slopes
    };
    Eigen::Matrix<double, terms, terms> square = Eigen::Matrix<double, terms, terms>::Zero();
    Eigen::Vector<double, terms> right = Eigen::Vector<double, terms>::Zero();
    std::array<Known, 7> known{};
    if (feet.size() > known.size())
        feet = feet.first(known.size());
    for (std::size_t f = 0; f < feet.size(); ++f) {
        const Vec3d way = (base::cast<double>(feet[f].position) - out.m_middle) / out.m_radius;
        const Vec3d n = base::cast<double>(feet[f].normal);
        const double steep = dot(n, out.m_normal);
        if (!(steep > leastCosine))
            return std::nullopt;
        known[f] = {dot(way, out.m_u),
                    dot(way, out.m_v),
                    {dot(way, out.m_normal), -dot(n, out.m_u) / steep, -dot(n, out.m_v) / steep}};
        const auto rows = rowsAt(known[f].a, known[f].b);
        for (std::size_t r = 0; r < 3; ++r) {
            const double weight = r == 0 ? 1 : slopeReach * slopeReach;
            const Eigen::Map<const Eigen::Vector<double, terms>> row(rows[r].data());
            square += weight * row * row.transpose();
            right += weight * known[f].told[r] * row;
        }
    }
    square.diagonal().array() += damping * square.trace() / terms;
    const Eigen::LLT<Eigen::Matrix<double, terms, terms>> factors(square);
    if (factors.info() != Eigen::Success)
        return std::nullopt;
    Eigen::Map<Eigen::Vector<double, terms>>(out.m_factors.data()) = factors.solve(right);
    for (std::size_t f = 0; f < feet.size(); ++f) {
        const Height found = out.heightAt(known[f].a, known[f].b);
        const double off = std::max(std::abs(found.value - known[f].told[0]),
                                    slopeReach * std::hypot(found.a - known[f].told[1], found.b - known[f].told[2]));
        if (!(off * out.m_radius <= double(most)))
            return std::nullopt;
    }
    return out;
}

Foot SmoothPatch::at(const base::Vec3f& x) const {
    const Vec3d way = (base::cast<double>(x) - m_middle) / m_radius;
    const double a = dot(way, m_u), b = dot(way, m_v);
    const Height h = heightAt(a, b);
    const Vec3d position = m_middle + (m_u * a + m_v * b + m_normal * h.value) * m_radius;
    const Vec3d normal = m_normal - m_u * h.a - m_v * h.b;
    return {base::cast<float>(position), base::cast<float>(normal / length(normal))};
}

} // namespace render
