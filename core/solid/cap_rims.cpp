#include "core/solid/cap_rims.h"

#include "core/base/parallel.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/left_rims.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/rims.h"
#include "core/tree/with_surfels.h"

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

/// Farther than surface::rimReach: rims that the points tell lie beyond the last row, and it is ragged.
constexpr float reach = 0.7F;

/// With the mark on all surfels beside places of rims.
tree::SurfelTree marked(const tree::SurfelTree& tree, std::span<const Vec3d> rims) {
    surfel::SurfelList places;
    for (const Vec3d& x : rims)
        places.items.push_back({base::cast<float>(x), {}, 1});
    const tree::SurfelTree near = tree::SurfelTree::build(places);
    surfel::SurfelList list = process::withRimAttribute(tree).surfels();
    const surfel::Attribute& rim = *list.layout->find(surface::rimName);
    const std::size_t words = list.layout->words();
    base::parallelFor(list.size(), 256, [&](std::size_t i) {
        std::vector<tree::Neighbour> nearest;
        const surfel::Surfel& s = list.items[i];
        near.nearest(s.position, 1, nearest, reach * s.support);
        surfel::write(rim, std::span(list.extra).subspan(i * words, words), nearest.empty() ? 0 : 1);
    });
    return tree::withSurfels(tree, list);
}

bool hasOthersRim(const surface::Surface& surface) {
    const surfel::Attribute* found = surface.tree().layout()->find(surface::rimName);
    return found && (surfel::isReal(found->type) || !surface.definition().knownRims);
}

} // namespace

Combined endingAsBefore(const surface::Surface& model, const Side& side, int kept, Combined capped,
                        const base::Progress& progress) {
    const surface::SurfaceDefinition& definition = model.definition();
    if (!std::isfinite(definition.boundaryLimit) || capped.removed == 0)
        return capped;
    const std::vector<surface::BoundaryCurve> curves = findBoundaryCurves(model, progress);
    capped.open = passing(curves, side);
    if (definition.boundary != surface::Boundary::Auto || hasOthersRim(model))
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
    surface::SurfaceDefinition known = capped.surface.definition();
    if (stay.empty()) {
        known.knownRims = false;
        known.boundaryLimit = std::numeric_limits<float>::infinity();
        capped.surface = {capped.surface.tree(), known};
        return capped;
    }
    known.knownRims = true;
    capped.surface = {marked(capped.surface.tree(), stay), known};
    return capped;
}

bool endIsKnown(const surface::Surface& surface) {
    return surface::knowsRims(surface) || (std::isinf(surface.definition().boundaryLimit) && !hasOthersRim(surface) &&
                                           surface.definition().boundary == surface::Boundary::Auto);
}

} // namespace solid
