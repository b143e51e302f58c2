// What a block by itself tells of the spacing around its surfels, from above: others around can only be nearer. A
// hundredth of what a search costs.
#pragma once

#include "core/surfel/surfel_block.h"

namespace sculpt {

struct OwnBlock {
    /// 0.93 times the mean distance of the six nearest that face alike, apart from its place; infinite where there are
    /// fewer.
    alignas(64) float ring[surfel::blockCapacity];
    /// How many stand within a radius of it, itself among them.
    alignas(64) float within[surfel::blockCapacity];
};

/// `radiusSq`: of each slot, for `within`.
void lookWithin(const surfel::SurfelBlock& block, const float (&radiusSq)[surfel::blockCapacity], OwnBlock& out);

} // namespace sculpt
