#include "core/surface/surface.h"

namespace surface {

/// W = E^T Hs E / |g| in a tangent basis E; its eigenvalues are the principal curvatures (alg. 7).
Curvature curvature(const Evaluationd& e) {
    const double slope = length(e.gradient);
    const base::Vec3d nu = base::normalized(e.gradient, {0, 0, 1});
    const base::Vec3d u = base::perpendicular(nu), v = cross(nu, u);
    const base::Vec3d hu = e.hessian * u, hv = e.hessian * v;
    const double a = dot(u, hu) / slope, b = 0.5 * (dot(u, hv) + dot(v, hu)) / slope, c = dot(v, hv) / slope;
    const double mean = 0.5 * (a + c), radius = std::hypot(0.5 * (a - c), b);
    const double angle = 0.5 * std::atan2(b, 0.5 * (a - c));
    const base::Vec3d first = u * std::cos(angle) + v * std::sin(angle);
    return {mean + radius, mean - radius, first, cross(nu, first)};
}

} // namespace surface
