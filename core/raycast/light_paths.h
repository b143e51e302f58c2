// Light that arrives along a ray by way of glass or metal (raycast/README 4.7): reflected and refracted rays are
// followed until they leave the model, all of a batch together, one bounce after the other. No chance is involved.
//
// Glass: a ray enters where d.g < 0 and leaves where d.g > 0, by Snell's law; Fresnel's equations say how much is
// reflected, Beer's law how much the way inside absorbs. Where there is no inside, the surface is a thin pane that
// bends nothing: surfels without a common sign, the back of an open surface, and a ray that entered but finds no way
// out.
#pragma once

#include "core/raycast/light_points.h"

namespace raycast {

/// Linear light along the rays that hit `points`: out[i] for points seen as Model, untouched for others. directions[i]
/// is the ray's.
void followLight(const LightScene& scene, std::span<const LightPoint> points, std::span<const base::Vec3f> directions,
                 std::span<base::Vec3f> out, LightCounts& counts);

} // namespace raycast
