// Light that arrives along a ray by way of glass or metal (alg. 4.2): reflected and refracted rays followed until they
// leave the model, all of a batch together, one bounce after the other. No chance is involved.
//
// Glass: a ray enters where d.g < 0 and leaves where d.g > 0, by Snell's law, with Fresnel's parts reflected and
// refracted; the way inside is absorbed by Beer's law. Where there is no inside it is a thin pane that bends nothing:
// surfels without a common sign, the back of an open surface, and wherever a ray that entered finds no way out.
#pragma once

#include "core/raycast/places.h"

namespace raycast {

/// Linear light along the rays that met `places`: out[i] for places seen as Model, untouched for others. `direction(i)`
/// is that of the ray.
void followLight(const LightScene& scene, std::span<const Place> places, std::span<const base::Vec3f> directions,
                 std::span<base::Vec3f> out, LightCounts& counts);

} // namespace raycast
