#include "core/raycast/patch.h"

namespace raycast {

namespace {

constexpr float normalTarget = 0.0349066f; // 2 degrees
constexpr float depthTarget = 0.2f;        // spacings
constexpr float colourTarget = 8, maskTarget = 8 / 255.0f;

using Values = std::array<float, Knot::Count>;

Values mean(std::initializer_list<const Knot*> knots) {
    Values out{};
    for (const Knot* knot : knots)
        for (std::size_t k = 0; k < Knot::Count; ++k)
            out[k] += knot->v[k] / static_cast<float>(knots.size());
    return out;
}

float normalError(const Values& predicted, const Knot& found) {
    const base::Vec3f n =
        normalized(base::Vec3f{predicted[Knot::NormalX], predicted[Knot::NormalY], predicted[Knot::NormalZ]});
    // A chord is as good as its angle where it matters.
    return length(n - found.normal()) / normalTarget;
}

/// Along the ray, in model units.
float depthError(const Values& predicted, const Knot& found, double stretch, const ViewLens& lens) {
    const auto t = [&](float even) {
        const auto d = static_cast<double>(even);
        return stretch * (lens.parallel() ? d : 1 / d);
    };
    return static_cast<float>(std::abs(t(predicted[Knot::Depth]) - t(found.v[Knot::Depth])));
}

float attributeError(const Values& predicted, const Knot& found) {
    float worst = std::abs(predicted[Knot::Mask] - found.v[Knot::Mask]) / maskTarget;
    for (const std::size_t k : {Knot::Red, Knot::Green, Knot::Blue})
        worst = std::max(worst, std::abs(predicted[k] - found.v[k]) / colourTarget);
    return worst;
}

} // namespace

float predictionError(const Patch& patch, const std::array<double, 9>& stretch, const ViewLens& lens, PatchKind kind) {
    const auto& k = patch.knots;
    for (const Knot& knot : k)
        if (!knot.hit || (kind.oriented && knot.behind != k[0].behind))
            return std::numeric_limits<float>::infinity();
    const Values predictions[5] = {mean({&k[0], &k[2]}), mean({&k[0], &k[6]}), mean({&k[0], &k[2], &k[6], &k[8]}),
                                   mean({&k[2], &k[8]}), mean({&k[6], &k[8]})};
    constexpr std::size_t between[5] = {1, 3, 4, 5, 7};
    float worst = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        const Knot& found = k[between[i]];
        const float spacing = kind.spacingOfUnit * found.v[Knot::Unit];
        worst = std::max({worst, normalError(predictions[i], found),
                          depthError(predictions[i], found, stretch[between[i]], lens) / (depthTarget * spacing)});
        if (kind.attributes)
            worst = std::max(worst, attributeError(predictions[i], found));
    }
    return worst;
}

} // namespace raycast
