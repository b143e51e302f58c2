// How a blended pixel becomes a colour. Every shading is the same formula with other tables, so that the CPU, the GL
// shader and the ray caster agree by construction:
//
//     rgb = light[n] * (usesColour ? colour : 1) * lerp(1, maskTint, mask) * lerp(1, backTint, back)
//
// `light` is a square picture of a lit ball (a matcap), made by code and looked up by the x and y of the normal in the
// frame of the pixel's own ray, so that the look of a place does not depend on where in the image it stands.
#pragma once

#include "ui/render/renderer.h"

#include <algorithm>

namespace render {

/// Side of the picture of the lit ball: one texel changes no channel by more than a step or two.
constexpr int lightSize = 512;

struct ShadingStyle {
    std::vector<surfel::Colour> light; ///< lightSize squared; row 0 is normal y = +1
    bool usesColour = false;
    base::Vec3f maskTint; ///< factor where the mask is 1
    base::Vec3f backTint; ///< factor for the inside of an oriented surface
};

/// Made once on first use; safe from any thread.
const ShadingStyle& shadingStyle(Shading shading);

/// Facing (cosine) below which an oriented surface counts as seen from inside. Not zero: splats that turn away at a
/// silhouette reach a pixel past it, and would draw a fringe there in the light of the other side. From the second on
/// the tint of the inside is full.
constexpr float backFrom = -0.2f, backTo = -0.4f;

/// `normal` (camera coordinates: x right, y up, z towards the eye) turned by the rotation that takes the direction
/// towards the eye, (-dx, -dy, 1) normalised, to z. The pixel's ray runs along (dx, dy, -1).
inline base::Vec3f inRayFrame(const base::Vec3f& n, float dx, float dy) {
    const float inverse = 1 / std::sqrt(dx * dx + dy * dy + 1);
    const base::Vec3f v{-dx * inverse, -dy * inverse, inverse};
    const float facing = dot(n, v), s = (facing + n.z) / (1 + v.z);
    return {n.x - s * v.x, n.y - s * v.y, facing};
}

/// The formula above. `n` unit length, in the frame of the ray; n.z < 0 where the surface is seen from inside.
inline surfel::Colour shadePixel(const ShadingStyle& style, base::Vec3f n, surfel::Colour colour, float mask) {
    const float back = std::clamp((n.z - backFrom) / (backTo - backFrom), 0.0f, 1.0f);
    if (n.z < backFrom)
        n = -n;
    else if (n.z < 0)
        n *= 1 / std::sqrt(n.x * n.x + n.y * n.y); // the outline of the ball
    constexpr float half = 0.5f * (lightSize - 1);
    const int column = std::clamp(static_cast<int>(half + half * n.x + 0.5f), 0, lightSize - 1);
    const int row = std::clamp(static_cast<int>(half - half * n.y + 0.5f), 0, lightSize - 1);
    const surfel::Colour light = style.light[static_cast<std::size_t>(row * lightSize + column)];
    surfel::Colour out = 0xff000000u;
    for (std::size_t k = 0; k < 3; ++k) {
        float c = static_cast<float>(light >> (8 * k) & 255);
        if (style.usesColour)
            c *= static_cast<float>(colour >> (8 * k) & 255) * (1.0f / 255);
        c *= (1 + mask * (style.maskTint[k] - 1)) * (1 + back * (style.backTint[k] - 1));
        out |= static_cast<surfel::Colour>(c + 0.5f) << (8 * k);
    }
    return out;
}

/// One row of background: 8 pixels that repeat along x, dithered so that the gradient shows no bands.
/// `transparent` gives alpha 0.
void backgroundRow(int row, int height, bool transparent, surfel::Colour out[8]);

} // namespace render
