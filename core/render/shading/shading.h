// How a blended pixel becomes a colour. Every shading is the same formula with other tables, so that the CPU, the GL
// shader and the ray caster agree by construction:
//
//     rgb = seen * colour * lerp(1, maskTint, mask)                     colour white where the shading shows none
//     seen = lerp(light[n], light[-n] * backTint, back)         back = 1 inside of an oriented surface, else 0
//
// `light` is a square picture of a lit ball (a matcap), made by code and looked up by the x and y of the normal in the
// frame of the pixel's own ray, so that the look of a place does not depend on where in the image it stands.
#pragma once

#include "core/render/renderer.h"

#include <algorithm>

namespace render {

/// Side of the picture of the lit ball: one texel changes no channel by more than a step or two.
constexpr int lightSize = 512;

struct ShadingStyle {
    std::vector<surfel::Colour> light; ///< lightSize squared; row 0 is normal y = +1
    bool usesColour = false;           ///< else the surfels' colours are not to be given to it
    base::Vec3f maskTint;              ///< factor where the mask is 1
    base::Vec3f backTint;              ///< factor for the inside of an oriented surface
};

/// Made from the row of the table on first use; safe from any thread.
const ShadingStyle& shadingStyle(Shading shading);

/// Facing (cosine) between which `back` grows from 0 to 1. It starts below zero because splats that turn away at a
/// silhouette reach a little past it, and would draw a fringe there in the light of the other side.
constexpr float backFrom = -0.15f, backTo = -0.6f;

/// `normal` (camera coordinates: x right, y up, z towards the eye) turned by the rotation that takes the direction
/// towards the eye, (-dx, -dy, 1) normalised, to z. The pixel's ray runs along (dx, dy, -1).
inline base::Vec3f inRayFrame(const base::Vec3f& n, float dx, float dy) {
    const float inverse = 1 / std::sqrt(dx * dx + dy * dy + 1);
    const base::Vec3f v{-dx * inverse, -dy * inverse, inverse};
    const float facing = dot(n, v), s = (facing + n.z) / (1 + v.z);
    return {n.x - s * v.x, n.y - s * v.y, facing};
}

/// The picture's texel for a unit normal; beyond the outline of the ball, the outline's.
inline surfel::Colour lightAt(const ShadingStyle& style, base::Vec3f n) {
    if (n.z < 0)
        n *= 1 / std::sqrt(n.x * n.x + n.y * n.y + 1e-12f);
    constexpr float half = 0.5f * (lightSize - 1);
    const int column = std::clamp(static_cast<int>(half + half * n.x + 0.5f), 0, lightSize - 1);
    const int row = std::clamp(static_cast<int>(half - half * n.y + 0.5f), 0, lightSize - 1);
    return style.light[static_cast<std::size_t>(row * lightSize + column)];
}

/// The formula above, in whatever colour is given. `n` unit length, in the frame of the ray; n.z < 0 where the surface
/// is seen from inside.
inline surfel::Colour shadePixel(const ShadingStyle& style, const base::Vec3f& n, surfel::Colour colour, float mask) {
    const surfel::Colour light = lightAt(style, n);
    const float back = std::clamp((n.z - backFrom) / (backTo - backFrom), 0.0f, 1.0f);
    const surfel::Colour inside = back > 0 ? lightAt(style, -n) : light;
    surfel::Colour out = 0xff000000u;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto channel = [&](surfel::Colour from) { return static_cast<float>(from >> (8 * k) & 255u); };
        float c = channel(light);
        c += back * (channel(inside) * style.backTint[k] - c);
        c *= channel(colour) * (1.0f / 255);
        c *= 1 + mask * (style.maskTint[k] - 1);
        out |= static_cast<surfel::Colour>(c + 0.5f) << (8 * k);
    }
    return out;
}

} // namespace render
