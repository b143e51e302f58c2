#include "core/render/splats/splat_scale.h"

#include "core/base/ranked.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/render/splats/disc_gaps.h"
#include "core/render/splats/splat_kernels.h"

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

/// Discs that reach beyond the farthest gap by this leave no hole, and blend.
constexpr float beyondGap = 1.2f;
/// Octaves of the ratio from which samples count as few, and within which they come to: with the least part that is
/// left, slowly enough for the scale to grow with the ratio all the same.
constexpr float fewFrom = 0.4f, fewWithin = 0.7f, narrowest = 0.65f;

float coveredBy(std::vector<float>& ratios) {
    return base::ranked(ratios, static_cast<std::size_t>(covered * static_cast<float>(ratios.size() - 1)));
}

/// Where few samples carry the shape, a disc is as large as a feature, and stands out over outlines: it becomes no
/// larger than gaps ask for, which are small where samples are relaxed. In octaves, up to 0.
float narrowed(const tree::SurfelTree& model, float ratio) {
    const float few = std::clamp((std::log2(ratio) - fewFrom) / fewWithin, 0.0f, 1.0f);
    std::vector<float> gaps = few > 0 ? sampleGaps(model) : std::vector<float>();
    if (gaps.empty())
        return 0;
    const float wanted = beyondGap * coveredBy(gaps) / (splatRadiusOfSupport * ratio);
    return few * std::log2(std::clamp(wanted, narrowest, 1.0f));
}

/// 1 near 1, its argument far from it, and no jump between; in octaves.
float settled(float ratio) {
    const float octaves = std::log2(ratio), near = std::log2(nearOne);
    return std::copysign(std::clamp(2 * (std::abs(octaves) - near), 0.0f, std::abs(octaves)), octaves);
}

} // namespace

float splatScaleOf(const tree::SurfelTree& model) {
    std::vector<float> ratios;
    for (const process::SpacingSample& each : process::sampleSpacing(model))
        ratios.push_back(usualSupport * each.spacing / each.support);
    if (ratios.empty())
        return 1;
    const float most = std::clamp(coveredBy(ratios), 1e-3f, 4.0f);
    return std::exp2(std::round(steps * (settled(most) + narrowed(model, most))) / steps);
}

} // namespace render
