// The dab's own movement along the surface, for tools that carry something with the stroke.
#pragma once

#include "core/sculpt/tool.h"

#include <algorithm>

namespace sculpt {

/// The part of dab.travel in the plane of areaNormal, at most 0.3 R long: farther apart, dabs would fold what they
/// move.
inline base::Vec3f alongSurface(const Dab& dab) {
    const base::Vec3f m = dab.travel - dab.areaNormal * dot(dab.areaNormal, dab.travel);
    const float longest = 0.3f * dab.radius, l = length(m);
    return l > longest ? m * (longest / l) : m;
}

} // namespace sculpt
