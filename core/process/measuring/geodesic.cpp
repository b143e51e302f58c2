#include "core/process/measuring/geodesic.h"

#include "core/base/error.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/measuring/surface_walker.h"
#include "core/process/measuring/walks.h"

namespace process {

using base::Vec3d;
using surface::Surface;

GeodesicPoint footOf(const Surface& surface, const Vec3d& x) {
    std::vector<tree::Neighbour> nearest;
    surface.tree().nearest(base::cast<float>(x), 1, nearest);
    if (nearest.empty()) // no surfels, or so far away that float32 has no number for the distance
        throw base::Error("there is no surface at or near a place that was told", {}, "choose it on the model");
    const Vec3d beside = base::cast<double>(nearest.front().block->position(nearest.front().slot));
    const Vec3d facing = base::cast<double>(nearest.front().block->normal(nearest.front().slot));
    std::optional<SurfacePlace> found = placeNear(surface, x, facing);
    // A foot much farther than the nearest surfel is another place's: the projection went astray.
    if (!found || distance(found->position, x) > distance(beside, x) + found->unit)
        found = placeNear(surface, beside, facing);
    if (!found)
        throw base::Error("there is no surface at or near a place that was told", {}, "choose it on the model");
    return {found->position, found->normal, found->unit, found->rim};
}

Geodesic geodesic(const Surface& surface, const Vec3d& from, const Vec3d& to, const base::Progress& progress) {
    constexpr std::size_t mostWays = 8, mostLinks = std::size_t(1) << 28;
    const GeodesicPoint first = footOf(surface, from), last = footOf(surface, to);
    if (first.position == last.position)
        return {{first, last}, false, 0};
    std::optional<Geodesic> best;
    // Rows of points far apart need more neighbours to hang together.
    for (const std::size_t neighbours : {16, 64, 256}) {
        const Walks walks(surface, neighbours, part(progress, 0, 0.3));
        const auto ways = walks.between(first.position, last.position, mostWays, part(progress, 0.3, 0.6));
        for (std::size_t k = 0; k < ways.size(); ++k) {
            const double done = 0.6 + 0.4 * static_cast<double>(k) / static_cast<double>(ways.size());
            const auto found = straightened(surface, ways[k], part(progress, done, done));
            if (found && (!best || found->length < best->length))
                best = found;
        }
        if (best)
            return *best;
        // More links say nothing new, or take more memory than a measurement may.
        if (neighbours >= surface.tree().size() || 4 * neighbours * surface.tree().size() > mostLinks)
            break;
    }
    throw base::Error("no way along the surface leads from one place to the other", {},
                      "choose both on one piece of the model");
}

} // namespace process
