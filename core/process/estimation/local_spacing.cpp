// The spacing that edits around a place aim at.
#include "core/process/estimation/spacing.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/resample.h"

#include <algorithm>

namespace process {

/// Surfels looked at, and those in the middle of them whose own neighbours are all among them.
constexpr std::size_t looked = 60, measuredOnes = 20, ring = 6;
/// Supports count as made for the spacing where the two agree so far.
constexpr float agreement = 1.6f;

static float measuredSpacing(const std::vector<base::Vec3f>& near) {
    std::vector<float> spacings;
    for (std::size_t i = 0; i < std::min(measuredOnes, near.size()); ++i) {
        std::vector<float> distances;
        for (std::size_t j = 0; j < near.size(); ++j)
            if (const float sq = distanceSq(near[i], near[j]); sq > 0)
                distances.push_back(sq);
        if (distances.size() < ring)
            continue;
        std::partial_sort(distances.begin(), distances.begin() + ring, distances.end());
        spacings.push_back(spacingFromRing(distances));
    }
    return summarise(std::move(spacings)).median;
}

float localSpacing(const surface::Surface& surface, const base::Vec3f& x) {
    std::vector<tree::Neighbour> found;
    surface.tree().nearest(x, looked, found);
    std::vector<base::Vec3f> near;
    std::vector<float> supports;
    for (const tree::Neighbour& n : found) {
        near.push_back(n.block->position(n.slot));
        supports.push_back(n.block->support(n.slot));
    }
    const float measured = measuredSpacing(near);
    if (measured == 0 || surface.definition().support > 0)
        return measured;
    const float meant = spacingOf(surface.definition(), summarise(std::move(supports)).median);
    return meant < agreement * measured && measured < agreement * meant ? meant : measured;
}

} // namespace process
