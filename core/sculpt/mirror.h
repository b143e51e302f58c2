// One of the images that symmetry makes of a ray: up to eight mirror images, each turned about an axis.
#pragma once

#include "core/base/mat3.h"
#include "core/base/ray.h"
#include "core/sculpt/stroke/stroke_settings.h"

namespace sculpt {

/// Flips coordinates at the planes x = 0, y = 0, z = 0 of the file's coordinates, then turns about one of its axes.
struct Mirror {
    bool x = false, y = false, z = false;
    base::Vec3f planes; ///< where those planes lie in stored coordinates: minus the model's origin
    int axis = 2;       ///< of the turn
    int step = 0;       ///< of the turn, out of the copies; 0: none
    float cosine = 1, sine = 0;

    base::Vec3f direction(const base::Vec3f& d) const {
        const base::Vec3f flipped{x ? -d.x : d.x, y ? -d.y : d.y, z ? -d.z : d.z};
        return step == 0 ? flipped : turned(flipped);
    }
    bool identity() const { return !x && !y && !z && step == 0; }
    /// Exact for the identity: far from the planes the way there and back would round.
    base::Vec3f position(const base::Vec3f& p) const { return identity() ? p : planes + direction(p - planes); }
    base::Rayf ray(const base::Rayf& r) const { return {position(r.origin), direction(r.direction)}; }
    base::Mat3f matrix() const; ///< of `direction`
    /// Left and right change places.
    bool reflects() const { return (x != y) != z; }

    base::Vec3f turned(const base::Vec3f& d) const;
};

/// The identity first, then every combination of what is asked for; none twice. Quarter turns are exact.
std::vector<Mirror> mirrors(const Symmetry& symmetry, const base::Vec3d& origin);

} // namespace sculpt
