#include "core/process/cleaning/take_out.h"

#include "core/process/cleaning/list_change.h"
#include "core/process/estimation/cloud_supports.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/prepare.h"
#include "core/process/neighbours/cloud_neighbours.h"
#include "core/process/neighbours/neighbour_graph.h"

#include <algorithm>

namespace process {

/// True for each point beside whose position another one goes.
static std::vector<std::uint8_t> beside(const surfel::SurfelList& points, const std::vector<std::uint8_t>& removed,
                                        const base::Progress& progress) {
    const Cloud cloud(points.items, progress);
    std::vector<std::uint8_t> gone(cloud.size(), 1), at(cloud.size()), out(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!removed[i])
            gone[cloud.places()[i]] = 0;
    cloud.forEach(gradedNeighbours, progress, "Looking at neighbours", [&](std::size_t i, const Neighbours& near) {
        at[i] = std::any_of(near.index.begin(), near.index.end(), [&](std::uint32_t j) { return gone[j] != 0; });
    });
    for (std::size_t i = 0; i < points.size(); ++i)
        out[i] = at[cloud.places()[i]];
    return out;
}

surface::Surface takenOut(const surface::Surface& before, std::vector<std::uint8_t> removed, Supports supports,
                          const base::Progress& progress) {
    const auto left = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 0));
    if (left == removed.size())
        return before;
    if (left < 4)
        throw base::Error("next to nothing would be left: " + std::to_string(left) + " of " +
                              std::to_string(removed.size()) + " points",
                          "", "ask for less");
    surfel::SurfelList points = before.tree().surfels();
    const std::vector<std::uint8_t> near = supports == Supports::Everywhere
                                               ? std::vector<std::uint8_t>(points.size(), 1)
                                               : beside(points, removed, part(progress, 0, 0.4));
    ListChange change;
    for (const surfel::Surfel& s : points.items)
        change.supports.push_back(s.support);
    keepPoints(points, [&](std::size_t i) { return removed[i] == 0; });
    const Cloud cloud(points.items, part(progress, 0.4, 0.5));
    CloudNeighbours around;
    if (!(before.definition().support > 0))
        around = neighboursOf(cloud, 0, part(progress, 0.5, 0.7));
    const std::vector<float> fresh =
        supportsOf(cloud, points, before.definition(), std::move(around), part(progress, 0.7, 0.9));
    for (std::size_t i = 0, kept = 0; i < removed.size(); ++i) {
        if (removed[i])
            continue;
        if (near[i])
            change.supports[i] = fresh[cloud.places()[kept]];
        ++kept;
    }
    change.removed = std::move(removed);
    const surface::Surface out(changed(before.tree(), change), before.definition());
    return redefine(out, before.definition(), part(progress, 0.9, 1));
}

} // namespace process
