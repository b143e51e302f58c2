#include "core/cells/creases/patch_fit.h"

#include "core/base/mat3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cells {

using base::Vec3d;

namespace {

constexpr double reach = 3.3;            ///< spacings, where the weight is zero
constexpr std::size_t fewestOfPlane = 4; ///< surfels
constexpr double least = 0.02;           ///< spacings: no surface is more exact than that
constexpr double usualBend = 0.08;       ///< second derivative over spacing, of surfaces that have creases
constexpr int rounds = 4;                ///< in which surfels far off the patch lose their weight: they are not of it
constexpr double usualOff = 0.1;         ///< spacings, beside the noise
constexpr std::size_t unknowns = 6;      ///< 1 u v uu uv vv
using Row = std::array<double, unknowns>;

/// Solves A x = b in place for a positive definite A (Cholesky).
void solve(std::array<Row, unknowns>& a, Row& b) {
    for (std::size_t i = 0; i < unknowns; ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double sum = a[i][k];
            for (std::size_t m = 0; m < k; ++m)
                sum -= a[i][m] * a[k][m];
            a[i][k] = i == k ? std::sqrt(std::max(sum, 1e-12)) : sum / a[k][k];
        }
        for (std::size_t m = 0; m < i; ++m)
            b[i] -= a[i][m] * b[m];
        b[i] /= a[i][i];
    }
    for (std::size_t i = unknowns; i-- > 0;) {
        for (std::size_t m = i + 1; m < unknowns; ++m)
            b[i] -= a[m][i] * b[m];
        b[i] /= a[i][i];
    }
}

double weightAt(double distance) {
    const double part = distance / reach;
    return part < 1 ? (1 - part * part) * (1 - part * part) : 0;
}

} // namespace

PatchFit fitPatch(const SurfelLinks& links, std::span<const std::uint32_t> members, const Vec3d& p, const Vec3d& axis,
                  double spacing, double noise) {
    PatchFit out;
    if (members.size() < fewestOfPlane)
        return out;
    Vec3d middle;
    double total = 0;
    for (const std::uint32_t m : members) {
        const double weight = weightAt(base::distance(links.at(m), p) / spacing);
        middle += links.at(m) * weight;
        total += weight;
    }
    if (!(total > 0))
        return out;
    middle = middle / total;
    base::Mat3d spread;
    for (const std::uint32_t m : members) {
        const Vec3d d = (links.at(m) - middle) / spacing;
        spread += base::outer(d, d) * weightAt(base::distance(links.at(m), p) / spacing);
    }
    const base::SymmetricEigen<double> eigen = base::symmetricEigen(spread);
    if (!(eigen.value[1] > 4 * eigen.value[0]) || !(eigen.value[1] > 1e-3 * total))
        return out; // hardly more than a line of them
    const Vec3d n = dot(eigen.vector[0], axis) < 0 ? -eigen.vector[0] : eigen.vector[0];
    const Vec3d e1 = eigen.vector[2], e2 = cross(n, e1);
    const double prior = (noise * noise + least * least) / (usualBend * usualBend);
    const double usual = noise + usualOff;
    Row b{};
    for (int round = 0; round < rounds; ++round) {
        std::array<Row, unknowns> a{};
        Row sums{};
        for (std::size_t k = 0; k < unknowns; ++k)
            a[k][k] = k < 3 ? 1e-9 : prior;
        for (const std::uint32_t m : members) {
            const Vec3d d = (links.at(m) - p) / spacing;
            const double u = dot(d, e1), v = dot(d, e2);
            const Row row{1, u, v, u * u, u * v, v * v};
            double off = dot(d, n);
            for (std::size_t i = 0; i < unknowns; ++i)
                off -= b[i] * row[i];
            const double trust = round == 0 ? 1 : 1 / (1 + off * off / (usual * usual));
            const double weight = weightAt(length(d)) * trust * trust;
            for (std::size_t i = 0; i < unknowns; ++i) {
                for (std::size_t k = 0; k <= i; ++k)
                    a[i][k] += weight * row[i] * row[k];
                sums[i] += weight * row[i] * dot(d, n);
            }
        }
        solve(a, sums);
        b = sums;
    }
    out.known = true;
    out.normal = base::normalized(n - e1 * b[1] - e2 * b[2]);
    out.height = -b[0] * spacing * dot(out.normal, n);
    return out;
}

} // namespace cells
