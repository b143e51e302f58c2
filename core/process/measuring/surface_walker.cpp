#include "core/process/measuring/surface_walker.h"

#include "core/surface/curves/boundary.h"
#include "core/surface/projection/project.h"

namespace process {

using base::Vec3d;
using surface::Status;

static surface::OrientationHint hintOf(const surface::Surface& surface, const Vec3d& facing) {
    return surface.tree().layout()->oriented ? surface::OrientationHint{}
                                             : surface::OrientationHint{base::cast<float>(facing)};
}

static std::optional<SurfacePlace> placeAt(const Vec3d& x, const surface::Evaluationd& at) {
    const double slope = length(at.gradient);
    if (!(slope > 0.05) || !(at.unit > 0))
        return {};
    SurfacePlace out;
    out.position = x;
    out.normal = at.gradient / slope;
    out.bend = at.hessian * (1 / slope);
    out.unit = at.unit;
    return out;
}

/// Where a foot lies beyond the boundary.
static std::optional<SurfacePlace> rimNear(const surface::Surface& surface, const Vec3d& foot,
                                           const surface::OrientationHint& hint) {
    const surface::BoundarySearch found = surface::findBoundaryPoint(surface, foot, hint);
    if (!found.ok() || !(distance(found.point.position, foot) < 2 * found.point.unit))
        return {};
    const surface::Evaluationd at = surface.evaluateReference(found.point.position, surface::Need::Hessian, hint);
    if (!at.ok() && at.status != Status::BeyondBoundary)
        return {};
    std::optional<SurfacePlace> out = placeAt(found.point.position, at);
    if (out) {
        out->rim = true;
        out->outward = base::normalized(out->inPlane(found.point.outward));
    }
    return out;
}

std::optional<SurfacePlace> placeNear(const surface::Surface& surface, const Vec3d& x, const Vec3d& facing) {
    const surface::OrientationHint hint = hintOf(surface, facing);
    for (const surface::Projector projector : {surface::Projector::Orthogonal, surface::Projector::Almost}) {
        surface::ProjectOptions options;
        options.projector = projector;
        options.tolerance = 1e-10;
        options.need = surface::Need::Hessian;
        const surface::Projection<double> found = surface::projectReference(surface, x, options, hint);
        if (found.ok())
            return placeAt(found.foot, found.at);
        if (found.status == Status::BeyondBoundary)
            return rimNear(surface, found.foot, hint);
    }
    return {};
}

std::optional<SurfacePlace> walkedBy(const surface::Surface& surface, const SurfacePlace& from, Vec3d way) {
    constexpr double stride = 0.4; // of h: where the projection leads back for certain
    constexpr int mostSteps = 200;
    std::optional<SurfacePlace> at = from;
    for (int k = 0; k < mostSteps; ++k) {
        const double left = length(way), step = std::min(left, stride * at->unit);
        if (!(left > 0))
            break;
        at = placeNear(surface, at->position + way * (step / left), at->normal);
        if (!at)
            return {};
        Vec3d next = at->inPlane(way);
        if (at->rim)
            next -= at->outward * std::max(0.0, dot(next, at->outward));
        way = next * (length(next) > 0 ? (left - step) / std::max(length(next), 0.5 * left) : 0.0);
        if (step == left)
            break;
    }
    return at;
}

} // namespace process
