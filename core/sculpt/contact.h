// Where a ray touches the model, and how the surface lies around that place.
#pragma once

#include "core/surface/surface.h"

#include <optional>

namespace sculpt {

struct Contact {
    base::Vec3f position; ///< the ray's first intersection with the surface, exact (surface/README 4)
    base::Vec3f normal;   ///< unit gradient, facing against the ray; at outlines outwards where that is known
    float distance = 0;   ///< along the ray's unit direction
};

/// Nothing where the ray misses; holes of open scans are missed.
std::optional<Contact> contact(const surface::Surface& surface, const base::Rayf& ray);

struct Area {
    base::Vec3f centre; ///< mean position
    base::Vec3f normal; ///< mean of the unit normals, unit length
};

/// Means over the surfels within `radius` of the contact that face as it does; the contact itself where there are none
/// or where their normals cancel. Normals without meaningful signs are turned to the contact's side.
Area areaAround(const surface::Surface& surface, const Contact& contact, float radius);

} // namespace sculpt
