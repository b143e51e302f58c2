#include "core/solid/cap_rims.h"

#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/known_rims.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"

namespace solid {

using base::Vec3d;

namespace {

/// A place where a boundary passes from one side to the other.
std::optional<Vec3d> passing(std::span<const surface::BoundaryCurve> curves, const Side& side) {
    for (const surface::BoundaryCurve& curve : curves)
        for (std::size_t i = curve.closed ? 0 : 1; i < curve.points.size(); ++i) {
            const Vec3d &a = curve.points[i == 0 ? curve.points.size() - 1 : i - 1].position,
                        &b = curve.points[i].position;
            if ((side.at(a).value > 0) != (side.at(b).value > 0))
                return (a + b) * 0.5;
        }
    return {};
}

} // namespace

Combined endingAsBefore(const surface::Surface& model, const Side& side, int kept, Combined capped,
                        const base::Progress& progress) {
    const surface::SurfaceDefinition& definition = model.definition();
    if (!std::isfinite(definition.boundaryLimit) || capped.removed == 0)
        return capped;
    const std::vector<surface::BoundaryCurve> curves = findBoundaryCurves(model, progress);
    capped.open = passing(curves, side);
    if (!process::mayKnowRims(model))
        return capped;
    if (capped.open) {
        if (surface::knowsRims(model)) // the cap has a rim that nobody knows
            capped.surface = process::withOwnLimit(capped.surface.tree(), capped.surface.definition(), progress);
        return capped;
    }
    std::vector<Vec3d> stay;
    bool closed = true;
    for (const surface::BoundaryCurve& curve : curves) {
        if (!((side.at(curve.points[0].position).value > 0) == (kept > 0)))
            continue;
        closed = closed && curve.closed;
        for (const surface::BoundaryPoint& each : curve.points)
            stay.push_back(each.position);
    }
    if (surface::knowsRims(model) ? !stay.empty() : !closed)
        return capped;
    capped.surface = process::endingAt(capped.surface, stay);
    return capped;
}

} // namespace solid
