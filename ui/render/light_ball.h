// Pictures of a lit ball, made by code: what light a surface with a given normal sends to the eye.
//
// Light is added up in linear units and encoded as sRGB at the end. Directions are in the frame of the eye: x right,
// y up, z towards the eye.
#pragma once

#include "core/base/vec.h"

namespace render {

/// Neutral clay in a studio: a warm key light from the upper left, a cool fill from the right, sky and floor, a soft
/// gloss, and a rim that lifts outlines from the background. sRGB, 0 to 1.
base::Vec3f clayLight(const base::Vec3f& normal);

/// Nearly colourless light that leaves surfel colours as they are where the surface faces the eye. sRGB, 0 to 1.
base::Vec3f plainLight(const base::Vec3f& normal);

/// The normal itself as a colour: (n + 1) / 2.
base::Vec3f normalColour(const base::Vec3f& normal);

} // namespace render
