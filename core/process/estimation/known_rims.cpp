#include "core/process/estimation/known_rims.h"

#include "core/base/parallel.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/surface/rims.h"
#include "core/tree/with_surfels.h"

#include <algorithm>

namespace process {

constexpr float nowhere = std::numeric_limits<float>::infinity();

bool mayKnowRims(const surface::Surface& surface) {
    const surfel::Attribute* found = surface.tree().layout()->find(surface::rimName);
    return surface.definition().boundary == surface::Boundary::Auto &&
           (!found || (surface.definition().knownRims && !surfel::isReal(found->type)));
}

bool endIsKnown(const surface::Surface& surface) {
    return surface::knowsRims(surface) || (std::isinf(surface.definition().boundaryLimit) && mayKnowRims(surface));
}

surface::Surface endingAt(const surface::Surface& surface, std::span<const base::Vec3d> rims, float reach) {
    surface::SurfaceDefinition definition = surface.definition();
    const bool told = surface.tree().layout()->find(surface::rimName) != nullptr; // by surfels, of what was
    definition.knownRims = !rims.empty() || told;
    if (rims.empty())
        definition.boundaryLimit = nowhere;
    if (!definition.knownRims)
        return {surface.tree(), definition};
    surfel::SurfelList places;
    for (const base::Vec3d& x : rims)
        places.items.push_back({base::cast<float>(x), {}, 1});
    const tree::SurfelTree near = tree::SurfelTree::build(places);
    surfel::SurfelList list = withRimAttribute(surface.tree()).surfels();
    const surfel::Attribute& rim = *list.layout->find(surface::rimName);
    const std::size_t words = list.layout->words();
    base::parallelFor(list.size(), 256, [&](std::size_t i) {
        std::vector<tree::Neighbour> nearest;
        const surfel::Surfel& s = list.items[i];
        if (!rims.empty())
            near.nearest(s.position, 1, nearest, reach * s.support);
        surfel::write(rim, std::span(list.extra).subspan(i * words, words), nearest.empty() ? 0 : 1);
    });
    return {tree::withSurfels(surface.tree(), list), definition};
}

bool knowRimsTogether(std::span<const surface::Surface* const> surfaces) {
    return std::ranges::all_of(surfaces, [](const surface::Surface* each) { return endIsKnown(*each); }) &&
           std::ranges::any_of(surfaces, [](const surface::Surface* each) { return surface::knowsRims(*each); });
}

surface::Surface withKnownRims(tree::SurfelTree tree, surface::SurfaceDefinition definition,
                               const base::Progress& progress) {
    definition.knownRims = false;
    const auto limit = [&] { return automaticBoundaryLimit({tree, definition}, progress); };
    definition.boundaryLimit = limit();
    if (std::isinf(definition.boundaryLimit))
        return {std::move(tree), std::move(definition)};
    definition.knownRims = surface::hasRim(tree);
    definition.boundaryLimit = definition.knownRims ? limit() : nowhere;
    return {std::move(tree), std::move(definition)};
}

} // namespace process
