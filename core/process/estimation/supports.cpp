#include "core/process/estimation/supports.h"

#include "core/base/ranked.h"
#include "core/process/estimation/chance.h"
#include "core/process/estimation/cloud_supports.h"
#include "core/process/estimation/graded_field.h"
#include "core/process/estimation/outliers.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/scan_lines.h"

#include <algorithm>
#include <atomic>

namespace process {

namespace {

/// Of radii over distance (process/README 1.3).
constexpr float steepest = 0.5f;
/// A position that stands this many times sparser than the median of its neighbours is an outlier and gets no more.
constexpr float sparsest = 3.0f;
constexpr std::size_t grain = 4096;

/// An outlier's reach would otherwise follow its distance from everything, and grading would carry that into the model.
std::vector<float> withoutOutliers(std::span<const float> spacing, const NeighbourGraph& g) {
    std::vector<float> out(spacing.size());
    base::parallelFor(spacing.size(), grain, [&](std::size_t i) {
        const NeighbourGraph::Row row = g.row(i);
        float near[gradedNeighbours], least = spacing[row[0]];
        for (std::size_t k = 0; k < g.count(); ++k)
            least = std::min(least, near[k] = spacing[row[k]]);
        out[i] = spacing[i];
        if (spacing[i] <= sparsest * least)
            return; // the median is no less
        out[i] = std::min(spacing[i], sparsest * base::median(std::span(near, g.count())));
    });
    return out;
}

/// Means over a position and its neighbours.
std::vector<float> meansAround(std::span<const float> values, const NeighbourGraph& g) {
    std::vector<float> out(values.size());
    base::parallelFor(values.size(), grain, [&](std::size_t i) {
        const NeighbourGraph::Row row = g.row(i);
        float sum = values[i];
        for (std::size_t k = 0; k < g.count(); ++k)
            sum += values[row[k]];
        out[i] = sum / static_cast<float>(g.count() + 1);
    });
    return out;
}

/// How much farther each is to reach.
std::vector<float> reachesByChance(std::span<const float> spacing, const NeighbourGraph& g) {
    std::vector<float> out(spacing.size());
    base::parallelFor(out.size(), grain, [&](std::size_t i) {
        out[i] = std::min(g.distance(i, g.row(i)[0]) / std::max(spacing[i], 1e-18f), 1.0f);
    });
    out = meansAround(meansAround(out, g), g);
    base::parallelFor(out.size(), grain, [&](std::size_t i) { out[i] = reachByChance(out[i]); });
    return out;
}

/// As far as it goes: what grading has raised beyond its own reaches over gaps already, and grading still holds.
/// `own`: what every place asks for by itself; `wider`: how much farther it is to reach.
void widen(std::vector<float>& h, std::span<const float> own, std::span<const float> wider, const NeighbourGraph& g,
           const base::Progress& progress) {
    constexpr float raised = 2;
    std::vector<float> below(h.size());
    std::atomic<bool> any = false;
    base::parallelFor(h.size(), grain, [&](std::size_t i) {
        const float share = std::clamp(1 + raised - h[i] / own[i], 0.0f, 1.0f) * (wider[i] - 1);
        below[i] = -h[i] * (1 + share);
        if (share > 0)
            any.store(true, std::memory_order_relaxed);
    });
    if (!any)
        return;
    raise(below, g, steepest, progress);
    base::parallelFor(h.size(), grain, [&](std::size_t i) { h[i] = -below[i]; });
}

/// What grading has made this many times as wide as its own place asks for holds no more than so many times the
/// neighbours asked for, counted by every 16th position: on a sheet about what it holds at that width.
constexpr float farRaised = 3.0f;
constexpr std::size_t mostOfNeighbours = 10, countedEach = 16;

/// Piles and dense parts beside sparse ones would be raised until each of their positions holds all the others.
/// `own`: what every place asks for by itself.
void spareDense(std::vector<float>& h, std::span<const float> own, std::span<const base::Vec3f> positions,
                std::size_t neighbours, const base::Progress& progress) {
    const std::size_t most = (mostOfNeighbours * neighbours + countedEach - 1) / countedEach;
    const auto isRaised = [&](std::size_t i) { return h[i] > farRaised * own[i]; };
    bool any = false;
    for (std::size_t i = 0; i < h.size() && !any; ++i)
        any = isRaised(i);
    if (!any || positions.size() < countedEach * most)
        return;
    std::vector<surfel::Surfel> some; // along the Morton curve, hence evenly
    for (std::size_t i = 0; i < positions.size(); i += countedEach)
        some.emplace_back().position = positions[i];
    const Cloud counted(some, progress);
    base::parallelFor(h.size(), 1024, [&](std::size_t i) {
        if (isRaised(i))
            h[i] = std::min(h[i], std::max(own[i], counted.reach(positions[i], most)));
    });
}

} // namespace

std::vector<float> supportsOf(const Cloud& cloud, const surfel::SurfelList& points,
                              const surface::SurfaceDefinition& definition, CloudNeighbours near,
                              const base::Progress& progress) {
    const bool gaussian = definition.weight == surface::Weight::Gaussian;
    const float reach = gaussian ? surface::gaussianReach : 1.0f;
    if (definition.support > 0)
        return std::vector<float>(cloud.size(), definition.support * reach);
    if (cloud.size() < 2)
        return std::vector<float>(cloud.size(), 1.0f); // a lone point has no scale; any will do
    NeighbourGraph graph = neighbourGraph(cloud, points, std::move(near.table), near.spacing, part(progress, 0, 0.4));
    base::LargeArray<float> own = std::move(near.spacing);
    near = {};
    std::vector<float> h = withoutOutliers(own, graph);
    // On a curve the nearest are along it: no mean over a ring, and no gap that reaching farther would bridge.
    std::vector<float> wider = definition.manifold == surface::Manifold::Curve ? std::vector<float>(cloud.size(), 1.0f)
                                                                               : reachesByChance(own, graph);
    const float perSpacing = definition.unitInSpacings();
    base::parallelFor(h.size(), grain, [&](std::size_t i) {
        for (float* const value : {&own[i], &h[i]})
            *value = std::max(*value * perSpacing, 1e-18f); // denormal distances
    });
    const Outliers outliers = cutOutliers(graph, h);
    grade(h, graph, steepest, part(progress, 0.4, 0.9));
    if (!outliers.members.empty()) {
        lowerOutliers(h, graph, outliers, steepest);
        raise(h, graph, steepest, part(progress, 0.9, 1)); // what they see was graded without them
    }
    for (const std::uint32_t i : outliers.members)
        wider[i] = 1;
    widen(h, own, wider, graph, {nullptr, progress.cancel});
    spareDense(h, own, cloud.positions(), static_cast<std::size_t>(definition.neighbours), {nullptr, progress.cancel});
    if (gaussian)
        for (float& value : h)
            value *= surface::gaussianScale * reach;
    return h;
}

void assignSupports(surfel::SurfelList& points, const surface::SurfaceDefinition& definition,
                    const base::Progress& progress) {
    if (points.items.empty())
        return;
    const Cloud cloud(points.items, part(progress, 0, 0.2));
    CloudNeighbours near;
    if (!(definition.support > 0)) {
        near = neighboursOf(cloud, 0, part(progress, 0.2, 0.5));
        if (definition.manifold == surface::Manifold::Surface)
            lookBesideLines(cloud, near, part(progress, 0.5, 0.6));
    }
    const std::vector<float> h = supportsOf(cloud, points, definition, std::move(near), part(progress, 0.6, 1));
    base::parallelFor(points.size(), grain, [&](std::size_t i) { points.items[i].support = h[cloud.places()[i]]; });
}

} // namespace process
