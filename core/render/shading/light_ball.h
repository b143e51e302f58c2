// Pictures of a lit ball, made by code: what light a surface with a given normal sends to the eye, as sRGB, 0 to 1.
//
// Light is added up in linear units and encoded at the end (light_terms.h). Directions are in the frame of the eye:
// x right, y up, z towards the eye.
#pragma once

#include "core/base/vec.h"

namespace render {

/// Neutral clay in a studio: a warm key light from the upper left, a cool fill from the right, sky and floor, a soft
/// gloss, and a rim that lifts outlines from the background.
base::Vec3f clayLight(const base::Vec3f& normal);
/// Sculptor's red wax: light wraps further the redder it is.
base::Vec3f waxLight(const base::Vec3f& normal);
/// White glaze with the mirrored shapes of a window and a lamp.
base::Vec3f porcelainLight(const base::Vec3f& normal);
/// Polished metal in a room of lamps.
base::Vec3f bronzeLight(const base::Vec3f& normal);
/// Green stone that light shines through.
base::Vec3f jadeLight(const base::Vec3f& normal);
/// Stripes of equal elevation of the normal (isophotes of a light from above).
base::Vec3f zebraLight(const base::Vec3f& normal);
/// Neutral grey under a key, a fill, a head and a rim light.
base::Vec3f studioLight(const base::Vec3f& normal);
/// Nearly colourless light that leaves surfel colours as they are where the surface faces the eye.
base::Vec3f plainLight(const base::Vec3f& normal);
/// None: colours stay as they are.
base::Vec3f noLight(const base::Vec3f& normal);
/// The same for colours that mean numbers: flatter, and without any tint.
base::Vec3f measureLight(const base::Vec3f& normal);
/// The normal itself as a colour: (n + 1) / 2.
base::Vec3f normalColour(const base::Vec3f& normal);

} // namespace render
