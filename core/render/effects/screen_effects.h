// Effects on the finished picture, from depths and normals alone: one formula each (render/README 6.2), run by vectors
// on the CPU (screen_effects.cpp) and in a shader (ui/gl/gl_effect_shader.cpp).
//
// Depths are kept as nearness w = 1/z, or -z where rays are parallel: linear across the image on every plane, so that
//
//     bend = ((w[+] + w[-]) / 2 - w) / (unit rho)      of two opposite pixels at distance rho (in units of the image
//                                                      place), unit = w in perspective, 1 in parallel projection
//
// is zero on planes however they lie, 1 in the middle of a right-angled groove seen straight on, large behind the edge
// of something nearer and very negative on that edge. Numbers without a length: effects look alike at any distance.
//
//     rgb' = mix(rgb / (1 + d + d^2/2), ink, line)     d: the sum of dark effects, line: the strongest of lines
//
// All of it happens where the surface is seen; the background stays.
#pragma once

#include "core/render/effects/effect_rows.h"
#include "core/render/effects/pixel_geometry.h"
#include "core/render/view_frame.h"

#include <bit>

namespace render {

/// A pixel beside, and its image place relative to the middle.
struct EffectTap {
    int x = 0, y = 0; ///< pixels; y down
    float dx = 0, dy = 0;
    float inverseRho = 0; ///< 1 / distance
};

/// Where an effect looks: one of each pair of its rings, all of its disc.
struct EffectTaps {
    std::vector<EffectTap> all; ///< empty: the effect is off
    float discSq = 1;           ///< squared radius of the disc in units of the image place
};

/// The effects at a size of image: what both ways of running them read.
struct EffectPlan {
    Effects effects = 0;
    bool parallel = false;
    std::array<EffectTaps, effectCount> taps; ///< by the table's rows
    int reach = 0;                            ///< pixels that the farthest tap is away

    /// `pixelScale`: see RenderOptions.
    EffectPlan(Effects effects, const ViewFrame& view, float pixelScale);

    const EffectTaps& of(Effect effect) const { return taps[static_cast<std::size_t>(std::countr_zero(effect + 0u))]; }
    /// The most that a row can have.
    static constexpr std::size_t most(const EffectRow& row) {
        std::size_t out = row.disc > 0 ? discTaps : 0;
        for (const int radius : row.rings)
            out += radius > 0 ? 4 : 0;
        return out;
    }
    static constexpr int discTaps = 28;
};

/// Applies them to pixels [left, right) of a row in place; `colours` begins at `left`.
void applyEffects(const EffectPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int row, int left,
                  int right, surfel::Colour* colours);

} // namespace render
