// What pictures of lit balls are made of. Linear light; directions in the frame of the eye: x right, y up, z towards
// the eye.
#pragma once

#include "core/base/vec.h"

#include <algorithm>

namespace render::light {

using base::Vec3f;

/// Cosine with the terminator softened by `wrap`: the light reaches that far around the ball.
inline float wrapped(const Vec3f& n, const Vec3f& from, float wrap) {
    const float c = std::max(0.0f, (dot(n, from) + wrap) / (1 + wrap));
    return c * (0.4f + 0.6f * c);
}

/// Blinn & Phong's gloss for an eye on the z axis.
inline float gloss(const Vec3f& n, const Vec3f& from, float exponent) {
    const Vec3f half = normalized(from + Vec3f{0, 0, 1});
    return std::pow(std::max(0.0f, dot(n, half)), exponent);
}

/// Direction in which the eye's ray leaves a mirror.
inline Vec3f reflected(const Vec3f& n) {
    return n * (2 * n.z) - Vec3f{0, 0, 1};
}

/// 0 below a, 1 above b, smooth between.
inline float step(float a, float b, float x) {
    const float t = std::clamp((x - a) / (b - a), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// Schlick's part of the light that is reflected at the surface.
inline float fresnel(const Vec3f& n, float facing) {
    const float c = 1 - std::clamp(n.z, 0.0f, 1.0f);
    return facing + (1 - facing) * c * c * c * c * c;
}

inline Vec3f times(const Vec3f& a, const Vec3f& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// Filmic shoulder: highlights roll off instead of clipping. Then the sRGB transfer curve.
inline float encode(float linear) {
    const float rolled = linear / (1 + 0.18f * linear * linear);
    const float c = std::clamp(rolled, 0.0f, 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}
inline Vec3f encode(const Vec3f& c) {
    return {encode(c.x), encode(c.y), encode(c.z)};
}

} // namespace render::light
