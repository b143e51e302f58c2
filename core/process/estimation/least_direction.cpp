#include "core/process/estimation/least_direction.h"

#include <algorithm>
#include <cmath>

namespace process {

using base::Vec3d;

namespace {

constexpr int mostSteps = 12;
/// Squared length of the cross product, (l1 - l0)^2 (l2 - l0)^2 and a third of that at least, over the trace's fourth
/// power.
constexpr double clear = 1e-6;

/// The least root of x^3 - c2 x^2 + c1 x - c0, all of whose roots are >= 0: Newton's steps from 0 come nearer from
/// below, each twice as near in digits.
double leastRoot(double c2, double c1, double c0) {
    double x = 0;
    for (int k = 0; k < mostSteps; ++k) {
        const double value = ((x - c2) * x + c1) * x - c0, slope = (3 * x - 2 * c2) * x + c1;
        const double step = slope > 0 ? -value / slope : 0;
        if (!(step > 1e-16 * c2))
            break;
        x += step;
    }
    return x;
}

} // namespace

Vec3d leastDirection(const base::Mat3d& a) {
    const double xx = a[0][0], xy = a[0][1], xz = a[0][2], yy = a[1][1], yz = a[1][2], zz = a[2][2];
    const double trace = xx + yy + zz, yyzz = yy * zz - yz * yz;
    const double minors = yyzz + (xx * zz - xz * xz) + (xx * yy - xy * xy);
    const double determinant = xx * yyzz - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    const double l = leastRoot(trace, minors, determinant);
    // Rows of a - l lie across the direction.
    const Vec3d u{xx - l, xy, xz}, v{xy, yy - l, yz}, w{xz, yz, zz - l};
    const Vec3d ways[3] = {cross(u, v), cross(v, w), cross(w, u)};
    const Vec3d& best =
        *std::max_element(ways, ways + 3, [](const Vec3d& p, const Vec3d& q) { return lengthSq(p) < lengthSq(q); });
    const double square = lengthSq(best), scale = trace * trace;
    if (!(square > clear * scale * scale) || !std::isfinite(square))
        return base::symmetricEigen(a).vector[0];
    return best / std::sqrt(square);
}

} // namespace process
