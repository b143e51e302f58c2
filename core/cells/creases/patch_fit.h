// A patch through some surfels near a place: height and normal there, as they follow from one side of a crease alone.
#pragma once

#include "core/cells/creases/surfel_links.h"

namespace cells {

struct PatchFit {
    bool known = false; ///< were there enough surfels?
    base::Vec3d normal; ///< at the place below or above p, on the side of the axis
    double height = 0;  ///< of p above the patch, along the axis
};

/// A paraboloid over the plane of the members, which is bent no more than `noise` (spacings) lets it be seen: at the
/// rim of its surfels a plane tells the slope in their middle, and a free paraboloid mostly the noise. `axis` tells the
/// side.
PatchFit fitPatch(const SurfelLinks& links, std::span<const std::uint32_t> members, const base::Vec3d& p,
                  const base::Vec3d& axis, double spacing, double noise);

} // namespace cells
