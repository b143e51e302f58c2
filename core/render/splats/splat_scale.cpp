#include "core/render/splats/splat_scale.h"

#include "core/process/estimation/spacing_sample.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

/// h / s for 38 neighbours: sqrt(38 / pi).
constexpr float usualSupport = 3.478f;
/// The share of surfels whose discs shall be large enough. The middle one says nothing: where sampling is uneven, dense
/// places have most of the surfels and supports wider than their spacing asks for, and sparse ones would lose their
/// cover.
constexpr float covered = 0.95f;
/// Ratios up to this are left alone: the usual supports are graded. Above its square nothing is.
constexpr float nearOne = 1.3f;
/// Steps of an octave: an edit that hardly changes the sampling changes no splat.
constexpr float steps = 32;

/// 1 near 1, its argument far from it, and no jump between.
float settled(float ratio) {
    const float octaves = std::log2(ratio), near = std::log2(nearOne);
    const float kept = std::copysign(std::clamp(2 * (std::abs(octaves) - near), 0.0f, std::abs(octaves)), octaves);
    return std::exp2(std::round(steps * kept) / steps);
}

} // namespace

float splatScaleOf(const tree::SurfelTree& model) {
    std::vector<float> ratios;
    for (const process::SpacingSample& each : process::sampleSpacing(model))
        ratios.push_back(usualSupport * each.spacing / each.support);
    if (ratios.empty())
        return 1;
    const auto most = ratios.begin() + static_cast<std::ptrdiff_t>(covered * static_cast<float>(ratios.size() - 1));
    std::nth_element(ratios.begin(), most, ratios.end());
    return settled(std::clamp(*most, 1e-3f, 4.0f));
}

} // namespace render
