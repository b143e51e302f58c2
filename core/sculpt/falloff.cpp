#include "core/sculpt/falloff.h"

#include "core/base/clones.h"
#include "core/base/row_of_id.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sculpt {

/// Nearest that the steep curves come to their rim, where their slope is infinite.
constexpr float rim = 1e-6f;

// Smooth: 1 - 3 r^2 + 2 r^3, flat at both ends, so that a dab has neither a tip nor an edge.
static float smooth(float r) {
    return 1 + r * r * (2 * r - 3);
}
static float smoothSlope(float r) {
    return 6 * r * (r - 1);
}
static float sphere(float r) {
    return std::sqrt(std::max(0.0f, 1 - r * r));
}
static float sphereSlope(float r) {
    return -r / std::sqrt(std::max(rim, 1 - r * r));
}
static float root(float r) {
    return std::sqrt(std::max(0.0f, 1 - r));
}
static float rootSlope(float r) {
    return -0.5f / std::sqrt(std::max(rim, 1 - r));
}
static float sharp(float r) {
    return (1 - r) * (1 - r);
}
static float sharpSlope(float r) {
    return -2 * (1 - r);
}
static float linear(float r) {
    return 1 - r;
}
static float linearSlope(float) {
    return -1;
}
static float constant(float) {
    return 1;
}
static float constantSlope(float) {
    return 0;
}

constexpr FalloffRow rows[] = {
    {Falloff::Smooth, "smooth", "Smooth", smooth, smoothSlope},
    {Falloff::Sphere, "sphere", "Sphere", sphere, sphereSlope},
    {Falloff::Root, "root", "Root", root, rootSlope},
    {Falloff::Sharp, "sharp", "Sharp", sharp, sharpSlope},
    {Falloff::Linear, "linear", "Linear", linear, linearSlope},
    {Falloff::Constant, "constant", "Constant", constant, constantSlope},
    {Falloff::Custom, "custom", "Custom curve", linear, linearSlope},
};

std::span<const FalloffRow> falloffTable() {
    return rows;
}

const FalloffRow& row(Falloff falloff) {
    return *std::find_if(std::begin(rows), std::end(rows), [&](const FalloffRow& r) { return r.value == falloff; });
}

Falloff falloff(std::string_view id) {
    return base::rowOf(rows, id, {"there is no falloff '%'", "falloff", "choose one of %"}).value;
}

float weight(Falloff falloff, float r) {
    return r < 1 ? row(falloff).weight(r) : 0.0f;
}

/// Both curves are inlined into the loop, which then runs in vector registers.
template <float (*Weight)(float), float (*Slope)(float)>
[[gnu::always_inline]] static inline void fill(float plateau, std::span<const float> r, std::span<float> weight,
                                               std::span<float> slope) {
    const float scale = 1 / (1 - plateau);
    for (std::size_t i = 0; i < r.size(); ++i) {
        const float t = std::min(1.0f, std::max(0.0f, (r[i] - plateau) * scale));
        const float w = Weight(t), s = Slope(t) * scale;
        weight[i] = r[i] < 1 ? w : 0.0f;
        slope[i] = r[i] < 1 && r[i] > plateau ? s : 0.0f;
    }
}

static void fill(const BrushCurve& curve, float plateau, std::span<const float> r, std::span<float> weight,
                 std::span<float> slope) {
    const float scale = 1 / (1 - plateau);
    for (std::size_t i = 0; i < r.size(); ++i) {
        const float t = std::max(0.0f, (r[i] - plateau) * scale);
        weight[i] = r[i] < 1 ? curve.value(t) : 0.0f;
        slope[i] = r[i] < 1 && r[i] > plateau ? curve.slope(t) * scale : 0.0f;
    }
}

POINTCLAY_CLONES
void weights(Falloff falloff, float plateau, std::span<const float> r, std::span<float> weight, std::span<float> slope,
             const BrushCurve* curve) {
    switch (falloff) {
    case Falloff::Smooth:
        return fill<smooth, smoothSlope>(plateau, r, weight, slope);
    case Falloff::Sphere:
        return fill<sphere, sphereSlope>(plateau, r, weight, slope);
    case Falloff::Root:
        return fill<root, rootSlope>(plateau, r, weight, slope);
    case Falloff::Sharp:
        return fill<sharp, sharpSlope>(plateau, r, weight, slope);
    case Falloff::Linear:
        return fill<linear, linearSlope>(plateau, r, weight, slope);
    case Falloff::Constant:
        return fill<constant, constantSlope>(plateau, r, weight, slope);
    case Falloff::Custom:
        return curve ? fill(*curve, plateau, r, weight, slope) : fill<linear, linearSlope>(plateau, r, weight, slope);
    }
}

} // namespace sculpt
