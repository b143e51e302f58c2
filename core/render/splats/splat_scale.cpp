#include "core/render/splats/splat_scale.h"

#include "core/process/estimation/spacing.h"
#include "core/process/estimation/spacing_sample.h"

#include <algorithm>

namespace render {

/// h / s for 38 neighbours: sqrt(38 / pi).
constexpr float usualSupport = 3.478f;
/// Ratios this near to 1 are left alone: the usual supports are graded and rounded.
constexpr float nearOne = 1.3f;

float splatScaleOf(const tree::SurfelTree& model) {
    std::vector<float> ratios;
    for (const process::SpacingSample& each : process::sampleSpacing(model))
        ratios.push_back(usualSupport * each.spacing / each.support);
    if (ratios.empty())
        return 1;
    const float middle = process::summarise(std::move(ratios)).median;
    return middle > 1 / nearOne && middle < nearOne ? 1.0f : std::clamp(middle, 1e-3f, 4.0f);
}

} // namespace render
