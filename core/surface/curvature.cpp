#include "core/surface/curvature.h"

#include "core/surface/evaluation/packets.h"

#include <cassert>

namespace surface {

using base::Vec3d;

namespace {

Curvature failed(Status status, Cause cause) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr Vec3d none{nan, nan, nan};
    return {status, cause, nan, nan, none, none, none};
}

/// W = E^T Hs E / |g| in a tangent basis E; its eigenvalues are the principal curvatures. The 2x2 form keeps all digits
/// at umbilics, where mean +- sqrt(mean^2 - Gauss) loses half of them.
template <class T>
Curvature fromDerivatives(const base::Vec3<T>& gradient, const base::Mat3<T>& hessian) {
    const Vec3d g = base::cast<double>(gradient);
    base::Mat3d h;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            h.m[row][column] = static_cast<double>(hessian.m[row][column]);
    const double slope = length(g);
    if (!(slope > 1e-6))
        return failed(Status::Degenerate, Cause::NoGradient);
    const Vec3d nu = g / slope, u = base::perpendicular(nu), v = cross(nu, u), hu = h * u, hv = h * v;
    const double a = dot(u, hu) / slope, b = 0.5 * (dot(u, hv) + dot(v, hu)) / slope, c = dot(v, hv) / slope;
    const double mean = 0.5 * (a + c), radius = std::hypot(0.5 * (a - c), b);
    const double angle = 0.5 * std::atan2(b, 0.5 * (a - c));
    const Vec3d first = u * std::cos(angle) + v * std::sin(angle);
    return {Status::Ok, Cause::None, mean + radius, mean - radius, first, cross(nu, first), nu};
}

template <class T>
Curvature of(const Evaluation<T>& e) {
    if (!e.ok() && e.status != Status::BeyondBoundary)
        return failed(e.status, e.cause);
    return fromDerivatives(e.gradient, e.hessian);
}

/// The surface whose second derivatives are taken.
Surface widened(const Surface& surface) {
    SurfaceDefinition definition = surface.definition();
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return Surface(surface.tree(), definition).withSupportScale(definition.curvatureScale());
}

} // namespace

Curvature curvatureOf(const Evaluationd& e) {
    return of(e);
}

Curvature curvatureReference(const Surface& surface, const Vec3d& x, const OrientationHint& hint) {
    return of(widened(surface).evaluateReference(x, Need::Hessian, hint));
}

void curvature(const Surface& surface, std::span<const base::Vec3f> x, std::span<Curvature> out) {
    assert(x.size() == out.size());
    const Surface wide = widened(surface);
    forPackets(wide, x, 0, [&](Source& source, std::size_t i) { out[i] = of(source.evaluate(x[i], Need::Hessian)); });
}

} // namespace surface
