#include "core/solid/loops/loop_rings.h"

#include "core/base/parallel.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace solid {

using base::Vec3d;

namespace {

/// How far one ring lies from the next, in spacings: a part of the hole's radius where that is more, up to this many.
/// Narrow rings would carry how the surface leans beside the loop, and the noise of a scan, up to the middle.
constexpr double widestStep = 2, stepOfRadius = 0.3;

/// The loop without its raggedness, and straight across it: rings of ragged ones would cross each other.
Loop withoutRags(const Loop& loop) {
    constexpr std::size_t reach = 2; // places
    Loop out = loop;
    straighten(out, reach);
    const std::size_t n = out.size();
    std::vector<Vec3d> across(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3d chord = out.points[(i + 1) % n].position - out.points[(i + n - 1) % n].position;
        across[i] = normalized(cross(loop.points[i].normal, chord), loop.points[i].outward); // the hole is to the left
    }
    across = meansAlong(across, reach);
    for (std::size_t i = 0; i < n; ++i)
        out.points[i].outward = normalized(across[i], loop.points[i].outward);
    return out;
}

/// Of a ring, beside one of the loop's points.
struct RingPlace {
    Vec3d position, normal;
    double aside = 0; ///< the centre of the surfels, across the loop
    bool found = false;
};

RingPlace ringPlace(const surface::Surface& surface, const Vec3d& place, const LoopPoint& edge, double within) {
    const auto foot =
        surface::projectReference(surface, place, {.checkBoundary = false}, {base::cast<float>(edge.normal)});
    if (!foot.ok() || distance(foot.foot, place) >= within)
        return {place, edge.normal};
    return {foot.foot, normalized(foot.at.gradient, edge.normal), dot(foot.at.centroid - foot.foot, edge.outward),
            true};
}

} // namespace

LoopRings ringsAround(const surface::Surface& surface, const Loop& loop) {
    constexpr std::size_t reach = 4; // places: over which bends are evened out
    constexpr double most = 0.1;     // spacings: more is no leaning
    const std::size_t n = loop.size();
    const double radius = loop.length / (2 * std::numbers::pi);
    const Loop even = withoutRags(loop);
    std::vector<RingPlace> places((LoopRings::count + 1) * n);
    std::vector<double> bends(n, 0);
    base::parallelFor(n, 4, [&](std::size_t i) {
        const LoopPoint& edge = even.points[i];
        const double step = std::clamp(stepOfRadius * radius, edge.spacing, widestStep * edge.spacing);
        places[i] = ringPlace(surface, loop.points[i].position, edge, most * edge.spacing);
        for (std::size_t ring = 1; ring <= LoopRings::count; ++ring) {
            const double way = step * static_cast<double>(ring);
            places[ring * n + i] = ringPlace(surface, edge.position - edge.outward * way, edge, way);
        }
        const RingPlace &near = places[n + i], &far = places[2 * n + i];
        if (near.found && far.found)
            bends[i] = dot(near.normal - far.normal, edge.outward) / step;
    });
    bends = meansAlong(bends, reach);
    LoopRings out;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const RingPlace& at = places[k];
        const double limit = most * loop.points[k % n].spacing;
        const double high = std::clamp(0.5 * bends[k % n] * at.aside * at.aside, -limit, limit);
        (k < n ? out.edge : out.behind).push_back(at.position - at.normal * high);
    }
    return out;
}

} // namespace solid
