// Places on a surface, and steps along it: what ways are made of (straighten.h). Internal to this folder.
#pragma once

#include "core/surface/surface.h"

#include <optional>

namespace process {

/// A place on the surface with its second order. Where the surface has ended there, the nearest place of its rim.
struct SurfacePlace {
    base::Vec3d position;
    base::Vec3d normal; ///< unit gradient of f
    base::Mat3d bend;   ///< Hessian of f over |g|: a step u along the plane leaves it by -u.bend.u / 2
    double unit = 0;    ///< h
    bool rim = false;
    base::Vec3d outward; ///< of rims: unit, along the surface, away from it

    base::Vec3d inPlane(const base::Vec3d& v) const { return v - normal * dot(v, normal); }
};

/// The foot of x; `facing` tells the side where normals have none. None where the projection fails.
std::optional<SurfacePlace> placeNear(const surface::Surface& surface, const base::Vec3d& x, const base::Vec3d& facing);

/// Along the surface from a place, in steps that stay in its reach; at a rim along it.
std::optional<SurfacePlace> walkedBy(const surface::Surface& surface, const SurfacePlace& from, base::Vec3d way);

} // namespace process
