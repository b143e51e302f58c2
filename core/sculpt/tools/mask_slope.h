// How the mask varies over the surface, so that normals follow at the rim of what it protects.
//
//     g_i = argmin sum_j theta(|p_j - p_i| / h_i) (m_j - m_i - g . (p_j - p_i))^2
//
// over the surfels around i that face as it does, theta Wendland's kernel; a small ridge keeps g in the surface, across
// which nothing is known.
#pragma once

#include "core/tree/surfel_tree.h"

namespace sculpt {

/// Gradients of the mask at 16 surfels.
struct MaskSlopes {
    alignas(64) float gx[surfel::clusterSize] = {}, gy[surfel::clusterSize] = {}, gz[surfel::clusterSize] = {};
};

/// Fills `out` for a cluster and returns true; false where the mask does not vary within it
/// (gradients are 0): its rim is some spacings wide, so that a cluster of one value lies beside it, not in it.
bool maskSlopes(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int cluster, MaskSlopes& out);

} // namespace sculpt
