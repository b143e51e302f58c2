// One of the up to eight mirror images that symmetry makes of a ray.
#pragma once

#include "core/base/ray.h"
#include "core/sculpt/stroke.h"

namespace sculpt {

/// Flips coordinates at the planes x = 0, y = 0, z = 0 of the file's coordinates.
struct Mirror {
    bool x = false, y = false, z = false;
    base::Vec3f planes; ///< where those planes lie in stored coordinates: minus the model's origin

    base::Vec3f direction(const base::Vec3f& d) const { return {x ? -d.x : d.x, y ? -d.y : d.y, z ? -d.z : d.z}; }
    base::Vec3f position(const base::Vec3f& p) const { return planes + direction(p - planes); }
    base::Rayf ray(const base::Rayf& r) const { return {position(r.origin), direction(r.direction)}; }
};

/// The identity first, then every combination of the planes asked for.
std::vector<Mirror> mirrors(const Symmetry& symmetry, const base::Vec3d& origin);

} // namespace sculpt
