#include "ui/render/splat_scale.h"

#include <algorithm>

namespace render {

/// h / s for 38 neighbours: sqrt(38 / pi).
constexpr float usualSupport = 3.478f;
/// Spacing of a hexagonal layout over the mean distance to its 6 nearest (alg. 2.6).
constexpr float spacingOfMean = 0.93f;
constexpr std::uint32_t sampledBlocks = 256;
/// Ratios this near to 1 are left alone: the usual supports are graded and rounded.
constexpr float nearOne = 1.3f;

float splatScaleOf(const tree::SurfelTree& model) {
    if (model.size() < 7)
        return 1;
    std::vector<float> ratios;
    std::vector<tree::Neighbour> found;
    const std::uint32_t step = std::max(1u, model.blockCount() / sampledBlocks);
    for (std::uint32_t number = 0; number < model.blockCount(); number += step) {
        const surfel::BlockPtr block = model.block(number);
        const int slot = block->size() / 2;
        model.nearest(block->position(slot), 7, found); // itself and six others
        float sum = 0;
        for (const tree::Neighbour& n : found)
            sum += std::sqrt(n.distanceSq);
        ratios.push_back(usualSupport * spacingOfMean * sum / 6 / block->support(slot));
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle > 1 / nearOne && *middle < nearOne ? 1.0f : std::clamp(*middle, 1e-3f, 4.0f);
}

} // namespace render
