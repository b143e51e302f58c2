#include "core/process/resampling/resample.h"

#include "core/process/resampling/resample_cells.h"
#include "core/process/resampling/resample_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace process {

static float supportsPerSpacing(const surface::SurfaceDefinition& definition) {
    const float h = definition.unitInSpacings();
    return definition.weight == surface::Weight::Gaussian ? h * surface::gaussianScale * surface::gaussianReach : h;
}

float supportOf(const surface::SurfaceDefinition& definition, float spacing) {
    if (definition.support <= 0)
        return spacing * supportsPerSpacing(definition);
    return definition.weight == surface::Weight::Gaussian ? definition.support * surface::gaussianReach
                                                          : definition.support;
}

float spacingOf(const surface::SurfaceDefinition& definition, float support) {
    return support / supportsPerSpacing(definition);
}

/// Was the place of a gap taken by one that has gone since the grid was built?
static bool opened(const SampleSet& set, const Gap& gap) {
    const float clear = fillClear * set.target[gap.from];
    bool found = false;
    set.grid.forNear(gap.place, clear, [&](const PointGrid::Entry& e) {
        found |= set.is(e.index, Gone) && distanceSq(e.position, gap.place) < clear * clear;
    });
    return found;
}

/// Does the surface go on there, so that its end was nearer before?
static bool goesOn(const SampleSet& set, const Gap& gap) {
    return set.options.goesOn && set.options.goesOn(gap.place, set.position[gap.from]);
}

/// Leaves out gaps that were there before what is resampled was.
static void dropOld(const SampleSet& set, std::vector<Gap>& gaps) {
    std::erase_if(gaps,
                  [&](const Gap& gap) { return set.is(gap.from, Full) && !opened(set, gap) && !goesOn(set, gap); });
}

/// The steps after which no gap and no close pair is left among what was touched.
static void mergeAndFill(SampleSet& set, ScanResult& found, float distance, std::size_t& firstNew) {
    dropStrays(set, found.strays);
    merge(set, found.pairs, distance);
    std::erase_if(found.gaps, [&](const Gap& gap) { return set.is(gap.from, Gone) || set.is(gap.from, Scan); });
    std::vector<Gap> more = scan(set).gaps; // around what went
    std::vector<Gap> gaps;
    std::merge(found.gaps.begin(), found.gaps.end(), more.begin(), more.end(), std::back_inserter(gaps),
               [](const Gap& a, const Gap& b) { return std::tie(a.from, a.k) < std::tie(b.from, b.k); });
    dropOld(set, gaps);
    std::erase_if(gaps, [&](const Gap& gap) { return set.hasRefused(gap); });
    firstNew = fill(set, std::move(gaps));
}

/// Steps 1 to 4.
static void mergeFillAndRelax(SampleSet& set) {
    ScanResult found = scan(set);
    std::size_t firstNew = 0;
    const float closeSq = closeDistance * closeDistance;
    mergeAndFill(set, found, set.options.merge, firstNew);
    set.options.merge = mergeDistance;
    std::erase_if(found.pairs, [&](const ClosePair& pair) { return pair.distanceSq >= closeSq; });
    wake(set, found.pairs, firstNew);
    relax(set);
}

/// Step 4 alone.
static void relaxAsTheyAre(SampleSet& set) {
    if (set.options.order == Order::RelaxOnly)
        for (std::size_t i = 0; i < set.size(); ++i)
            set.unmark(i, Scan);
    wake(set, {}, set.size());
    relax(set);
}

/// Is there a sample with one of these flags?
static bool anyIs(const SampleSet& set, unsigned flag) {
    return std::any_of(set.flags.begin(), set.flags.end(), [&](std::uint8_t f) { return (f & flag) != 0; });
}

tree::Edit resample(const surface::Surface& version, const tree::Selection& touched, const ResampleOptions& options,
                    const surface::Surface& frozen) {
    if (touched.empty() || !(options.spacing > 0))
        return {};
    // mu = 0 erodes whatever is put back on it; the samples themselves carry the form with 1/2 (process/README 4.3).
    surface::SurfaceDefinition definition = frozen.definition();
    definition.shrinkFree = true;
    const surface::Surface ground(frozen.tree(), definition);

    const tree::Selection restless = restlessOf(version, touched, options);
    if (restless.empty() && !options.relaxAll)
        return {};
    SampleSet set(version, touched, restless, options, ground);
    if (options.order == Order::FillFirst)
        mergeFillAndRelax(set);
    else
        relaxAsTheyAre(set);
    if (!anyIs(set, Moved | Gone | Scan))
        return {};
    set.rebuildGrid();
    set.scanNearMoved(fillReach + relaxStep);
    ScanResult found = scan(set);
    std::size_t firstNew = 0;
    mergeAndFill(set, found, mergeDistance, firstNew);
    return settle(set);
}

tree::Edit resample(const surface::Surface& version, const tree::Selection& touched, const ResampleOptions& options) {
    if (std::optional<tree::Edit> byCells = resampleByCells(version, touched, options))
        return std::move(*byCells);
    return resample(version, touched, options, version);
}

tree::Selection selectAll(const tree::SurfelTree& tree) {
    tree::Selection out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::SelectedBlock all{number, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            all.slots.set(static_cast<std::size_t>(slot));
        out.push_back(all);
    });
    return out;
}

} // namespace process
