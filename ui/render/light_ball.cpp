#include "ui/render/light_ball.h"

#include <algorithm>

namespace render {

using base::Vec3f;

/// Cosine with the terminator softened by `wrap`: the light reaches that far around the ball.
static float wrapped(const Vec3f& n, const Vec3f& light, float wrap) {
    const float c = std::max(0.0f, (dot(n, light) + wrap) / (1 + wrap));
    return c * (0.4f + 0.6f * c);
}

/// Blinn & Phong's gloss for an eye on the z axis.
static float gloss(const Vec3f& n, const Vec3f& light, float exponent) {
    const Vec3f half = normalized(light + Vec3f{0, 0, 1});
    return std::pow(std::max(0.0f, dot(n, half)), exponent);
}

/// Filmic shoulder: highlights roll off instead of clipping. Then the sRGB transfer curve.
static float encode(float linear) {
    const float rolled = linear / (1 + 0.18f * linear * linear);
    const float c = std::clamp(rolled, 0.0f, 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

static Vec3f encode(const Vec3f& c) {
    return {encode(c.x), encode(c.y), encode(c.z)};
}

Vec3f clayLight(const Vec3f& n) {
    static const Vec3f key = normalized(Vec3f{-0.62f, 0.7f, 0.5f}), fill = normalized(Vec3f{0.86f, 0.08f, 0.4f}),
                       rim = normalized(Vec3f{0.35f, 0.75f, -0.55f});
    const float sky = 0.5f + 0.5f * n.y, graze = 1 - std::max(0.0f, n.z);
    Vec3f light = Vec3f{1.05f, 0.94f, 0.8f} * (0.86f * wrapped(n, key, 0.12f));
    light += Vec3f{0.46f, 0.66f, 0.98f} * (0.2f * wrapped(n, fill, 0.35f));
    light += Vec3f{0.4f, 0.46f, 0.55f} * (0.15f * sky) + Vec3f{0.46f, 0.37f, 0.31f} * (0.16f * (1 - sky));
    light *= 1 - 0.3f * graze * graze; // a little less light reaches what turns away: reads as depth
    const Vec3f clay{0.8f, 0.745f, 0.69f};
    Vec3f out{light.x * clay.x, light.y * clay.y, light.z * clay.z};
    out += Vec3f{1, 0.97f, 0.92f} * (0.09f * gloss(n, key, 18) + 0.06f * gloss(n, key, 80));
    out += Vec3f{0.75f, 0.85f, 1} * (0.32f * graze * graze * graze * std::max(0.0f, dot(n, rim) + 0.15f));
    return encode(out);
}

Vec3f plainLight(const Vec3f& n) {
    static const Vec3f key = normalized(Vec3f{-0.4f, 0.6f, 0.75f});
    const float light = 0.3f + 0.62f * wrapped(n, key, 0.5f) + 0.12f * n.z + 0.06f * n.y;
    return encode(Vec3f{1.02f, 1, 0.98f} * (light * 1.22f));
}

Vec3f normalColour(const Vec3f& n) {
    return (n + Vec3f{1, 1, 1}) * 0.5f;
}

} // namespace render
