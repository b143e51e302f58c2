// How wide discs must be so that no hole is left between them: the farthest corner of a surfel's cell among those of
// its sheet, in its tangent plane.
#pragma once

#include "core/tree/surfel_tree.h"

namespace render {

/// Of some 256 surfels spread evenly through the tree: that distance over the support (of an ellipsoid that of the ball
/// of the same area). Those whose cell has no end, as at rims, say nothing. Cost: their searches.
std::vector<float> sampleGaps(const tree::SurfelTree& tree);

} // namespace render
