// Splats are sized by the supports of their surfels, which usually tell the spacing: h = 3.48 s. Where they do not (one
// radius for all, another number of neighbours, a Gaussian, radii from a file) this is the RenderOptions::splatScale
// that makes up for it.
#pragma once

#include "core/tree/surfel_tree.h"

namespace render {

/// What 3.48 spacings / support stays below at 95 % of some surfels; 1 where it is near 1. Where it is large, as of
/// reduced models, no more than the gaps between surfels ask for (disc_gaps.h). It follows the model without
/// a jump, in steps of 2 %. A few hundred searches: for when a model is opened or edited, not for every frame.
float splatScaleOf(const tree::SurfelTree& model);

} // namespace render
