// The spacing that edits around a place aim at.
#include "core/process/estimation/chance.h"
#include "core/process/estimation/spacing.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <cmath>

namespace process {

/// Surfels looked at, and those in the middle of them whose own neighbours are all among them.
constexpr std::size_t looked = 60, measuredOnes = 20, ring = 6;
/// Supports count as made for the spacing where the two agree so far.
constexpr float agreement = 1.6f;

namespace {

struct Around {
    float measured = 0; ///< spacing; 0: nothing tells
    float nearest = 1;  ///< neighbour on the mean, over that
    float support = 0;
};

Around around(const surface::Surface& surface, const base::Vec3f& x) {
    std::vector<tree::Neighbour> found;
    surface.tree().nearest(x, looked, found);
    std::vector<float> supports, spacings;
    for (const tree::Neighbour& n : found)
        supports.push_back(n.block->support(n.slot));
    float sum = 0;
    for (std::size_t i = 0; i < std::min(measuredOnes, found.size()); ++i) {
        const base::Vec3f at = found[i].block->position(found[i].slot);
        std::vector<float> distances;
        for (const tree::Neighbour& other : found)
            if (const float sq = distanceSq(at, other.block->position(other.slot)); sq > 0)
                distances.push_back(sq);
        if (distances.size() < ring)
            continue;
        std::partial_sort(distances.begin(), distances.begin() + ring, distances.end());
        spacings.push_back(spacingFromRing(distances));
        sum += std::min(std::sqrt(distances[0]) / spacings.back(), 1.0f);
    }
    Around out;
    if (!spacings.empty())
        out.nearest = sum / static_cast<float>(spacings.size());
    out.measured = summarise(std::move(spacings)).median;
    out.support = summarise(std::move(supports)).median;
    return out;
}

/// One support for all, and curves, know nothing of chance.
float reachOf(const surface::SurfaceDefinition& definition, const Around& here) {
    if (here.measured == 0 || definition.support > 0 || definition.manifold != surface::Manifold::Surface)
        return 1;
    return std::min(reachByChance(here.nearest), std::max(1.0f, spacingOf(definition, here.support) / here.measured));
}

} // namespace

float reachByChance(const surface::Surface& surface, const base::Vec3f& x) {
    return reachOf(surface.definition(), around(surface, x));
}

float localSpacing(const surface::Surface& surface, const base::Vec3f& x) {
    const Around here = around(surface, x);
    const surface::SurfaceDefinition& definition = surface.definition();
    if (here.measured == 0 || definition.support > 0)
        return here.measured;
    const float meant = spacingOf(definition, here.support) / reachOf(definition, here);
    return meant < agreement * here.measured && here.measured < agreement * meant ? meant : here.measured;
}

} // namespace process
