#include "core/process/estimation/boundary_limit.h"

#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/rim_runs.h"

#include <algorithm>
#include <numbers>

namespace process {

namespace {

constexpr std::size_t mostSamples = 20000;                 ///< a quantile of 1 % needs no more
constexpr float closedGap = std::numbers::pi_v<float> / 2; ///< a neighbourhood with no larger gap is closed
constexpr float tightest = 0.15f;
constexpr float bandLimit = 0.3f; ///< for bands so narrow that all their samples see a rim
/// By chance alone P(o > L) = exp(-(L / rms)^2). The 99 % quantile of closed neighbourhoods tells rms; this
/// times that is what one sample in 1e5 exceeds: (6) of process/README 3. (1.3 is what one in 2400 exceeds: a handful
/// of pinholes in every scan.)
constexpr float rareOverQuantile = 1.58f; // sqrt(ln 1e5 / ln 100)

/// Surfels at equal distances in tree order.
std::vector<RimPlace> samplePlaces(const tree::SurfelTree& tree) {
    const std::size_t stride = (tree.size() + mostSamples - 1) / mostSamples;
    std::vector<RimPlace> out;
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot, ++at)
            if (at % stride == 0)
                out.push_back({rimKey(number, slot), block.position(slot)});
    });
    return out;
}

} // namespace

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress) {
    const std::vector<RimSample> samples = lookAt(surface, samplePlaces(surface.tree()), part(progress, 0, 0.7));

    std::vector<float> closed;
    for (const RimSample& s : samples)
        if (s.gap < closedGap)
            closed.push_back(s.offCentre);
    if (!hasOpenRun(surface, samples, part(progress, 0.7, 1)))
        return std::numeric_limits<float>::infinity();
    if (closed.empty())
        return bandLimit;
    const auto quantile = closed.begin() + static_cast<std::ptrdiff_t>((closed.size() - 1) * 99 / 100);
    std::nth_element(closed.begin(), quantile, closed.end());
    return std::clamp(rareOverQuantile * *quantile, tightest, loosestLimit);
}

} // namespace process
