// The rows of the table of effects: what each is called, where it looks around a pixel, and the numbers of its formula.
//
// To add one: a row here, its formula by vectors in screen_effects.cpp, and in GLSL in ui/gl/gl_effect_shader.cpp.
// Menus, settings, options, uniforms, the shader's constants and the tests follow from the row.
#pragma once

#include "core/render/effects/effect_table.h"
#include "core/render/shared_constant.h"

#include <array>

namespace render {

/// In the order of the table.
enum Effect : Effects { EyeDome = 1, Occlusion = 2, Outline = 4, Creases = 8, Contours = 16 };

/// What an effect does with its number.
enum class EffectKind {
    Dark, ///< light falls by it
    Line  ///< ink covers that part of the pixel
};

struct EffectRow {
    Effect effect;
    const char* id; ///< "eye-dome"
    const char* label;
    const char* tip;
    EffectKind kind;
    const char* word; ///< its function in the shader; what it looks at is called after it
    /// Radii of squares of eight neighbours in four opposite pairs, in pixels that a person sees; 0: no such square.
    std::array<int, 3> rings;
    float disc; ///< radius of a disc of neighbours as a part of the image's height; 0: none
    std::span<const SharedConstant> constants;
};

constexpr SharedConstant domeStrength{"domeStrength", 0.8f}, domeMost{"domeMost", 3};
inline constexpr SharedConstant domeConstants[] = {domeStrength, domeMost};

constexpr SharedConstant skyStrength{"skyStrength", 7}, skyBias{"skyBias", 0.08f};
inline constexpr SharedConstant skyConstants[] = {skyStrength, skyBias};

/// 1 - cosine between opposite normals; n.v, since where the surface turns away everything bends
constexpr SharedConstant creaseFrom{"creaseFrom", 0.18f}, creaseTo{"creaseTo", 0.5f};
constexpr SharedConstant creaseFacingFrom{"creaseFacingFrom", 0.3f}, creaseFacingTo{"creaseFacingTo", 0.65f};
inline constexpr SharedConstant creaseConstants[] = {creaseFrom, creaseTo, creaseFacingFrom, creaseFacingTo};

/// Depth of the valley of n.v; n.v from where contours fade and beyond which there are none
constexpr SharedConstant contourFrom{"contourFrom", 0.015f}, contourTo{"contourTo", 0.06f};
constexpr SharedConstant contourFacingFrom{"contourFacingFrom", 0.5f}, contourFacingTo{"contourFacingTo", 0.75f};
inline constexpr SharedConstant contourConstants[] = {contourFrom, contourTo, contourFacingFrom, contourFacingTo};

/// Of all effects: -bend that begins and completes a step of depth; lightness and strength of ink
constexpr SharedConstant stepFrom{"stepFrom", 3}, stepTo{"stepTo", 8};
constexpr SharedConstant lineInk{"lineInk", 0.07f}, lineStrength{"lineStrength", 0.88f};
inline constexpr SharedConstant effectConstants[] = {stepFrom, stepTo, lineInk, lineStrength};

inline constexpr EffectRow effectRows[] = {
    {EyeDome,
     "eye-dome",
     "Eye-Dome Lighting",
     "Darkens grooves and what lies behind an edge",
     EffectKind::Dark,
     "dome",
     {1, 2, 4},
     0,
     domeConstants},
    {Occlusion,
     "ambient-occlusion",
     "Ambient Occlusion",
     "Shadows where little of the sky can be seen",
     EffectKind::Dark,
     "sky",
     {},
     0.06f,
     skyConstants},
    {Outline,
     "outline",
     "Outlines",
     "Lines where the surface ends in front of something farther away",
     EffectKind::Line,
     "outline",
     {1},
     0,
     {}},
    {Creases, "creases", "Creases", "Lines along sharp edges", EffectKind::Line, "crease", {2}, 0, creaseConstants},
    {Contours,
     "contours",
     "Suggestive Contours",
     "Lines that would become outlines if the eye moved a little",
     EffectKind::Line,
     "contour",
     {3},
     0,
     contourConstants},
};
constexpr std::size_t effectCount = std::size(effectRows);

} // namespace render
