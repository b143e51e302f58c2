#include "core/process/estimation/boundary_limit.h"

#include "core/base/ranked.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/rim_runs.h"
#include "core/surface/rims.h"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace process {

namespace {

constexpr std::size_t mostSamples = 20000;                 ///< a quantile of 1 % needs no more
constexpr float closedGap = std::numbers::pi_v<float> / 2; ///< a neighbourhood with no larger gap is closed
constexpr float rowGap =
    5 * std::numbers::pi_v<float> / 6; ///< of those in the last row: half a turn, where it is straight
constexpr float tightest = 0.15f, tightestKnown = 0.1f;
constexpr float bandLimit = 0.3f; ///< for bands so narrow that all their samples see a rim
/// By chance alone P(o > L) = exp(-(L / rms)^2), whose rms a quantile of 1 % tells. L at surfels is what one sample in
/// 1e5 exceeds: (6) of process/README 3. (1.3 times the quantile is what one in 2400 exceeds: a handful of pinholes in
/// every scan.)
constexpr float rareOverQuantile = 1.58f; // sqrt(ln 1e5 / ln 100)
/// Gaps have their maximum of o where no surfel is: so far off, in h, towards where there are fewer. One in so many
/// times as many as there are surfels may exceed L there; beyond `widestGap` this would rather close holes.
constexpr float intoGap = 0.25f, gapsPerFalse = 1e5f, widestGap = 0.32f;

/// Surfels at equal distances in tree order, of those that are wanted.
template <class Wanted>
std::vector<RimPlace> samplePlaces(const tree::SurfelTree& tree, const Wanted& wanted) {
    const auto forWanted = [&](const auto& fn) {
        tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (wanted(block, slot))
                    fn(number, block, slot);
        });
    };
    std::size_t all = 0, at = 0;
    forWanted([&](auto, auto&, int) { ++all; });
    const std::size_t stride = (all + mostSamples - 1) / mostSamples;
    std::vector<RimPlace> out;
    forWanted([&](std::uint32_t number, const surfel::SurfelBlock& block, int slot) {
        if (at++ % stride == 0)
            out.push_back({rimKey(number, slot), block.position(slot)});
    });
    return out;
}

std::vector<float> offCentres(std::span<const RimSample> samples) {
    std::vector<float> out(samples.size());
    std::transform(samples.begin(), samples.end(), out.begin(), [](const RimSample& each) { return each.offCentre; });
    return out;
}

/// What one in `rare` exceeds, by the 99 % quantile.
float rarelyExceeded(std::vector<float> values, double factor) {
    return values.empty() ? 0 : static_cast<float>(factor) * base::ranked(values, (values.size() - 1) * 99 / 100);
}

/// Off-centre values beside samples, towards where there are fewer, at closed neighbourhoods.
std::vector<float> offCentreInGaps(const surface::Surface& surface, std::span<const RimSample> closed,
                                   const base::Progress& progress) {
    std::vector<base::Vec3f> x(closed.size());
    std::transform(closed.begin(), closed.end(), x.begin(), [](const RimSample& each) { return each.foot; });
    std::vector<surface::Evaluationf> at(x.size());
    surface.evaluate(x, surface::Need::Value, at);
    std::vector<RimPlace> places;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (at[i].ok() && at[i].offCentre > 0)
            places.push_back(
                {closed[i].at.key, x[i] + (x[i] - at[i].centroid) * (intoGap * at[i].unit / at[i].offCentre)});
    std::vector<float> out;
    for (const RimSample& each : lookAt(surface, places, progress))
        if (each.gap < closedGap)
            out.push_back(each.offCentre);
    return out;
}

/// The surface is to end at its last row, but not in what is closed beside it.
float limitOfKnownRims(const surface::Surface& surface, const base::Progress& progress) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    const std::vector<RimPlace> places = samplePlaces(surface.tree(), [&](const surfel::SurfelBlock& block, int slot) {
        return surface::isBesideRim(block, slot, layout);
    });
    if (places.empty())
        return std::numeric_limits<float>::infinity();
    std::vector<RimSample> closed = lookAt(surface, places, progress), row;
    std::ranges::copy_if(closed, std::back_inserter(row), [](const RimSample& each) { return each.gap > rowGap; });
    std::erase_if(closed, [](const RimSample& each) { return !(each.gap < closedGap); });
    if (row.empty())
        return bandLimit;
    std::vector<float> ends = offCentres(row);
    const float most = base::ranked(ends, ends.size() * 9 / 10);
    return std::clamp(std::max(most, rarelyExceeded(offCentres(closed), rareOverQuantile)), tightestKnown,
                      loosestLimit);
}

} // namespace

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress) {
    if (surface::knowsRims(surface))
        return limitOfKnownRims(surface, progress);
    std::vector<RimSample> samples =
        lookAt(surface, samplePlaces(surface.tree(), [](auto&, int) { return true; }), part(progress, 0, 0.6));
    if (!hasOpenRun(surface, samples, part(progress, 0.6, 0.9)))
        return std::numeric_limits<float>::infinity();
    std::erase_if(samples, [](const RimSample& each) { return !(each.gap < closedGap); });
    if (samples.empty())
        return bandLimit;
    const float atSurfels = rarelyExceeded(offCentres(samples), rareOverQuantile);
    const double rare = gapsPerFalse * static_cast<double>(surface.tree().size());
    const float inGaps = rarelyExceeded(offCentreInGaps(surface, samples, part(progress, 0.9, 1)),
                                        std::sqrt(std::log(rare) / std::log(100.0)));
    return std::clamp(std::max(atSurfels, std::min(inGaps, widestGap)), tightest, loosestLimit);
}

surface::Surface withOwnLimit(tree::SurfelTree tree, surface::SurfaceDefinition definition,
                              const base::Progress& progress) {
    definition.knownRims = false;
    if (definition.boundary == surface::Boundary::Auto)
        definition.boundaryLimit = automaticBoundaryLimit({tree, definition}, progress);
    return {std::move(tree), std::move(definition)};
}

} // namespace process
