// The last step of every tool that deforms: 16 surfels get their new places, normals and, where footprints follow,
// supports.
//
//     p' = p + d        n' = m / |m|        h' = h sqrt(|m|),    m = cof(F) n: |m| is the stretch of area
//
// Where `turns` is 0 normal and support keep their bits, where d is 0 the place does.
#pragma once

#include "core/surfel/surfel_block.h"

namespace sculpt {

struct MovedLanes {
    alignas(64) float d[3][surfel::clusterSize];  ///< displacement
    alignas(64) float m[3][surfel::clusterSize];  ///< turned normal, of any length
    alignas(64) float turns[surfel::clusterSize]; ///< 1 or 0
};

void move(surfel::SurfelBlock& block, int cluster, const MovedLanes& by, bool footprints);

} // namespace sculpt
