#include "core/layers/inherited.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace layers {

using base::Vec3d;

/// Three times what a quadratic has terms: those of other sheets fall away.
constexpr std::size_t neighbours = 18, terms = Inheritance::terms;
/// Cosine of normals from which two surfels are on the same side of a sheet.
constexpr double facing = 0.2;
/// A place is on the surface within this part of the nearest surfel's support of its plane: about a spacing.
constexpr double onSurface = 0.25;
/// In the distance of the farthest neighbour: nearer than this one surfel counts alone.
constexpr double coincident = 1e-3;
/// Ridge of the fit, in the weight of the farthest neighbour: they may lie in a row.
constexpr double ridge = 1e-3;

/// x becomes A^-1 x, for a positive definite matrix (elimination).
static void solve(std::array<std::array<double, terms>, terms>& a, std::array<double, terms>& x) {
    for (std::size_t k = 0; k < terms; ++k)
        for (std::size_t i = k + 1; i < terms; ++i) {
            const double f = a[i][k] / a[k][k];
            for (std::size_t j = k; j < terms; ++j)
                a[i][j] -= f * a[k][j];
            x[i] -= f * x[k];
        }
    for (std::size_t k = terms; k-- > 0;) {
        for (std::size_t j = k + 1; j < terms; ++j)
            x[k] -= a[k][j] * x[j];
        x[k] /= a[k][k];
    }
}

bool Inheritance::gather(const SurfelLayers::Shown& place) {
    m_near.clear();
    if (!m_known || m_tree.empty())
        return false;
    m_tree.nearest(base::cast<float>(place.position), neighbours, m_near);
    std::erase_if(m_near, [&](const tree::Neighbour& each) {
        const Vec3d n = base::cast<double>(each.block->normal(each.slot));
        return lengthSq(n) > 0 && lengthSq(place.normal) > 0 && !(dot(n, place.normal) > facing);
    });
    if (m_near.empty())
        return false;
    const tree::Neighbour& nearest = m_near.front();
    const Vec3d apart = place.position - base::cast<double>(nearest.block->position(nearest.slot));
    const Vec3d n = base::cast<double>(nearest.block->normal(nearest.slot));
    const double h = double(nearest.block->support(nearest.slot));
    return length(apart) < h && std::abs(dot(n, apart)) < onSurface * h;
}

/// Weights l_j with sum l_j v_j = the constant of the quadratic fit to v_j at u_j, in the tangent plane about the
/// place: l_j = w_j phi(u_j) . M^-1 phi(0), M = sum w phi phi^T.
void Inheritance::weigh(const SurfelLayers::Shown& place) {
    const Vec3d n = lengthSq(place.normal) > 0 ? place.normal : Vec3d{0, 0, 1};
    const Vec3d s = base::perpendicular(n), t = cross(n, s);
    const double reach = std::sqrt(std::max(double(m_near.back().distanceSq), 1e-30)), least = coincident * coincident;
    std::array<double, terms> c{}; // M^-1 phi(0)
    std::array<std::array<double, terms>, terms> m{};
    m_rows.clear();
    for (const tree::Neighbour& each : m_near) {
        const Vec3d apart = (base::cast<double>(each.block->position(each.slot)) - place.position) / reach;
        const double u = dot(s, apart), v = dot(t, apart);
        const Row row{{1, u, v, u * u, u * v, v * v}, least / (lengthSq(apart) + least)};
        for (std::size_t i = 0; i < terms; ++i)
            for (std::size_t j = 0; j < terms; ++j)
                m[i][j] += row.weight * row.phi[i] * row.phi[j];
        m_rows.push_back(row);
    }
    for (std::size_t i = 1; i < terms; ++i)
        m[i][i] += ridge * m_rows.back().weight;
    c[0] = 1;
    solve(m, c);
    m_weights.clear();
    double sum = 0;
    for (const Row& row : m_rows) {
        double along = 0;
        for (std::size_t i = 0; i < terms; ++i)
            along += row.phi[i] * c[i];
        sum += m_weights.emplace_back(row.weight * along);
    }
    for (std::size_t j = 0; j < m_weights.size(); ++j)
        m_weights[j] = sum > 0 ? m_weights[j] / sum : (j == 0 ? 1.0 : 0.0);
}

void Inheritance::at(const SurfelLayers::Shown& place, SurfelLayers& out) {
    for (SurfelLayers::Part& part : out.parts)
        part = {};
    out.normal = place.normal;
    if (!gather(place))
        return;
    weigh(place);
    Vec3d normal;
    for (std::size_t j = 0; j < m_near.size(); ++j) {
        m_one.read(*m_near[j].block, m_near[j].slot, m_channels);
        normal += m_one.normal * m_weights[j];
        for (std::size_t i = 0; i < out.parts.size(); ++i) {
            out.parts[i].d += m_one.parts[i].d * m_weights[j];
            out.parts[i].e += m_one.parts[i].e * m_weights[j];
            out.parts[i].q += m_one.parts[i].q * m_weights[j];
            out.parts[i].mask += m_one.parts[i].mask * m_weights[j];
        }
    }
    for (SurfelLayers::Part& part : out.parts)
        part.mask = std::clamp(part.mask, 0.0, 1.0);
    out.normal = normalized(normal, place.normal);
}

} // namespace layers
