// How a field varies over the surface at one surfel, so that normals follow at its soft rim.
//
//     g = argmin sum_j theta(|p_j - p| / h) (v_j - v - g . (p_j - p))^2
//
// over the surfels within its support that face as it does, theta Wendland's kernel; a small ridge keeps g in the
// surface, across which nothing is known. As sculpt/tools/mask_slope.h does it for the mask in lanes.
#pragma once

#include "core/selection/field.h"

namespace selection {

/// `channel` as channelOf gives it. 1 / model units.
base::Vec3d slopeAt(const tree::SurfelTree& tree, int channel, const surfel::SurfelBlock& block, int slot);

} // namespace selection
