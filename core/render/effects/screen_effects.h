// Effects on the finished picture, from depths and normals alone: one formula, run by vectors on the CPU
// (screen_effects.cpp) and in a shader (gl_effect_shader.h).
//
// Depths are kept as nearness w = 1/z, or -z where rays are parallel: linear across the image on every plane, so that
//
//     bend = ((w[+] + w[-]) / 2 - w) / (unit rho)      of two opposite pixels at distance rho (in units of the image
//                                                      place), unit = w in perspective, 1 in parallel projection
//
// is zero on planes however they lie, 1 in the middle of a right-angled groove seen straight on, large behind the edge
// of something nearer and very negative on that edge. Numbers without a length: effects look alike at any distance.
//
//     rgb' = mix(rgb / (1 + d + d^2/2), ink, line)     d = domeStrength eyeDome + skyStrength occlusion
//     eyeDome    mean over pairs at several distances of clamp(bend, 0, 3)       after Boucheny (2009)
//     occlusion  mean over a disc of max(0, sine of the elevation above the tangent plane - bias) falling off with
//                distance                                                        after McGuire et al. (2011)
//     outline    where -bend of some pair is large: the surface goes on behind
//     creases    where opposite normals differ, without such a step between, and the surface faces the eye
//     contours   where n.v is in a valley: suggestive contours, DeCarlo et al. (2003), section 4.2
//
// All of it happens where the surface is seen; the background stays.
#pragma once

#include "core/render/effects/effect_table.h"
#include "core/render/effects/pixel_geometry.h"
#include "core/render/view_frame.h"

namespace render {

/// A pixel beside, and its image place relative to the middle.
struct EffectTap {
    int x = 0, y = 0; ///< pixels; y down
    float dx = 0, dy = 0;
    float inverseRho = 0; ///< 1 / distance
};

/// The effects at a size of image: what both ways of running them read.
struct EffectPlan {
    Effects effects = 0;
    bool parallel = false;
    std::vector<EffectTap> dome;     ///< one of each pair
    std::vector<EffectTap> sky;      ///< of the disc
    std::vector<EffectTap> lines;    ///< one of each pair, next to the pixel: steps
    std::vector<EffectTap> creases;  ///< pairs
    std::vector<EffectTap> contours; ///< pairs
    float skyRadiusSq = 1;           ///< of the disc, in units of the image place
    int reach = 0;                   ///< pixels that the farthest tap is away

    /// `pixelScale`: see RenderOptions.
    EffectPlan(Effects effects, const ViewFrame& view, float pixelScale);
};

/// Constants of the formulas, for both.
constexpr float domeStrength = 0.8f, domeMost = 3, skyStrength = 7, skyBias = 0.08f;
constexpr float stepFrom = 3, stepTo = 8;                        ///< -bend of an outline
constexpr float creaseFrom = 0.18f, creaseTo = 0.5f;             ///< 1 - cosine between opposite normals
constexpr float contourFrom = 0.015f, contourTo = 0.06f;         ///< depth of the valley of n.v
constexpr float contourFacing = 0.75f;                           ///< beyond this n.v no contour is drawn
constexpr float creaseFacingFrom = 0.3f, creaseFacingTo = 0.65f; ///< where the surface turns away everything bends
constexpr float lineInk = 0.07f, lineStrength = 0.88f;

/// Applies them to pixels [left, right) of a row in place; `colours` begins at `left`.
void applyEffects(const EffectPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int row, int left,
                  int right, surfel::Colour* colours);

} // namespace render
