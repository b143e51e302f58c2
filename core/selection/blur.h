// Fields made softer and harder, and fields from the shape: means over a ball about each surfel (selection/README 6).
//
//     mean(i) = sum_j a_j theta(|p_j - p_i| / r) v_j / sum_j a_j theta(...)      theta Wendland's kernel, a_j = s_j^2
//
// over the surfels that face as i does. The areas a_j make means independent of how densely the surface is sampled.
// Where the radius is below what links reach over it is that, so that every surfel has neighbours.
#pragma once

#include "core/base/progress.h"
#include "core/selection/field.h"
#include "core/surface/surface.h"

namespace selection {

tree::SurfelTree blurred(const surface::Surface& surface, Field field, double radius,
                         const base::Progress& progress = {});
/// v + amount (v - mean), within 0 and 1.
tree::SurfelTree sharpened(const surface::Surface& surface, Field field, double radius, double amount,
                           const base::Progress& progress = {});
/// strength times radius times the mean curvature of hollows at that radius, within 0 and 1; ridges have 0. Of a hollow
/// sphere of radius R: strength radius / R. Throws base::Error where normals have no sides.
tree::SurfelTree fromCavity(const surface::Surface& surface, Field field, double radius, double strength,
                            const base::Progress& progress = {});
/// Rises from 0 to 1 as the larger principal curvature goes from `low` to `high`, of either sign. 0 where it is not
/// known. REQUIRES: 0 <= low < high.
tree::SurfelTree fromCurvature(const surface::Surface& surface, Field field, double low, double high,
                               const base::Progress& progress = {});

} // namespace selection
