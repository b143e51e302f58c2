// A plane, and the half of space that it keeps: normal . x >= offset. Stored coordinates (relative to the model's
// origin) unless said otherwise. Float64.
#pragma once

#include "core/base/ray.h"

#include <span>

namespace base {

struct Plane {
    Vec3d normal{0, 0, 1}; ///< unit
    double offset = 0;     ///< normal . x on the plane

    bool operator==(const Plane&) const = default;

    /// Signed, > 0 on the side that is kept.
    double distance(const Vec3d& p) const { return dot(normal, p) - offset; }
    Plane flipped() const { return {-normal, -offset}; }
    /// The same plane where coordinates count from `origin`.
    Plane relativeTo(const Vec3d& origin) const { return {normal, offset - dot(normal, origin)}; }
};

/// Part of a ray, as distances from its origin.
struct RayPart {
    double first = 0, second = std::numeric_limits<double>::infinity();

    bool empty() const { return !(first < second); }
};

/// What all planes keep of the ray.
inline RayPart keptPart(const Rayd& ray, std::span<const Plane> planes) {
    RayPart out;
    for (const Plane& plane : planes) {
        const double height = plane.distance(ray.origin), rise = dot(plane.normal, ray.direction);
        if (rise > 0)
            out.first = std::max(out.first, -height / rise);
        else if (rise < 0)
            out.second = std::min(out.second, -height / rise);
        else if (height < 0)
            out.second = 0;
    }
    return out;
}

} // namespace base
