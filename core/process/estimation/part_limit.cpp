#include "core/process/estimation/part_limit.h"

#include "core/base/cancel_scope.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/left_rims.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/rims.h"

#include <algorithm>

namespace process {

using surface::Boundary;

namespace {

bool isIn(const tree::SurfelTree& tree, const base::Vec3f& place) {
    std::vector<tree::Neighbour> at;
    tree.nearest(place, 1, at);
    return !at.empty() && at[0].distanceSq == 0;
}

/// Where surfels were that the part lacks.
std::vector<base::Vec3f> placesLost(const tree::SurfelTree& whole, const tree::SurfelTree& part) {
    std::vector<base::Vec3f> out;
    for (const surfel::BlockPtr& block : diff(whole, part).removed) {
        base::CancelScope::check();
        for (int slot = 0; slot < block->size(); ++slot)
            if (!isIn(part, block->position(slot)))
                out.push_back(block->position(slot));
    }
    return out;
}

/// Did neighbours that look the same way lose each other?
bool parts(const tree::SurfelTree& whole, const tree::SurfelTree& part) {
    constexpr std::size_t looked = 8;
    constexpr int enough = 3; // one may be a stray
    constexpr float alike = 0.5f;
    int found = 0;
    std::vector<tree::Neighbour> near;
    for (const surfel::BlockPtr& block : diff(whole, part).removed) {
        base::CancelScope::check();
        for (int slot = 0; slot < block->size() && found < enough; ++slot) {
            const base::Vec3f x = block->position(slot);
            part.nearest(x, 1, near, block->support(slot));
            if (near.empty() || near[0].distanceSq == 0) // nothing is beside it, or it stays
                continue;
            whole.nearest(x, looked, near);
            found += std::ranges::any_of(near, [&](const tree::Neighbour& each) {
                return dot(each.block->normal(each.slot), block->normal(slot)) > alike &&
                       isIn(part, each.block->position(each.slot));
            });
        }
    }
    return found >= enough;
}

} // namespace

surface::Surface partOf(const surface::Surface& whole, tree::SurfelTree part, const base::Progress& progress,
                        bool learns) {
    constexpr float ofFewSurfels = 0.3f; // h: as for bands all of whose samples see a rim
    surface::SurfaceDefinition definition = whole.definition();
    const bool surface = definition.manifold == surface::Manifold::Surface,
               limitless = definition.boundary == Boundary::None && surface;
    if ((definition.boundary != Boundary::Auto && !limitless) || part == whole.tree())
        return {std::move(part), std::move(definition)};
    if (surface::knowsRims(whole))
        part = part.apply(rimsBeside({part, definition}, placesLost(whole.tree(), part)));
    const bool parted = surface && parts(whole.tree(), part);
    if (limitless && (!parted || !std::isinf(automaticBoundaryLimit(whole, process::part(progress, 0, 0.4)))))
        return {std::move(part), std::move(definition)}; // open though without a limit: somebody wants that
    if (learns && parted && std::isinf(whole.definition().boundaryLimit) && !part.layout()->find(surface::rimName)) {
        definition.knownRims = true; // it ended nowhere: where something went is all that there is of rims
        part = withRimAttribute(part);
        part = part.apply(rimsBeside({part, definition}, placesLost(whole.tree(), part)));
    }
    definition.boundary = Boundary::Auto;
    definition.boundaryLimit = automaticBoundaryLimit({part, definition}, process::part(progress, 0.4, 1));
    if (parted && std::isinf(definition.boundaryLimit))
        definition.boundaryLimit = ofFewSurfels;
    return {std::move(part), std::move(definition)};
}

} // namespace process
