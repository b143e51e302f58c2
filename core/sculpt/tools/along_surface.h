// The stroke's own direction along the surface, for tools that carry something with it or work across it.
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

/// Unit vector in the plane of areaNormal at right angles to the stroke; zero while the stroke has no direction.
inline base::Vec3f acrossStroke(const Dab& dab) {
    const base::Vec3f m = dab.travel - dab.areaNormal * dot(dab.areaNormal, dab.travel);
    return length(m) > 1e-3f * dab.radius ? cross(dab.areaNormal, normalized(m)) : base::Vec3f{};
}

} // namespace sculpt
