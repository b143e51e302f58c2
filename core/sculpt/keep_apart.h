// The two sides of something thin stay apart: what a dab would take through the other side, or so near to it that no
// support can tell them apart, goes no farther than that.
//
// Surfels i and j are two sides of one place where they face apart (n_i . n_j < -0.7), hardly beside each other (0.75
// s) and matter is between them: g = (x_i - x_j) . m > 0 along m = n_i - n_j, of unit length. After the dab
//
//     g' = (x_i' - x_j') . m'  >=  min(g, s / 2)
//
// m' along the normals as the dab has carried them, so that bending and turning bring nothing together. What lacks is
// given back by those that came nearer, each by its part of the way; their normals then become the other side's.
//
// Clay raises what lies deeper by more, and cutting knows nothing of the other side: within ten dabs a plate of a few
// spacings had no inside left. A plate of half a spacing still has a surface of its own on each side (surface/README
// 2.7).
#pragma once

#include "core/surface/surface.h"

namespace sculpt {

/// The edit of a dab with that done. `oneSpacing`: of models with one support for all. In parallel, the same bits at
/// any thread count; where nothing is thin it costs a look at the normals.
tree::Edit keptApart(const surface::Surface& version, tree::Edit edit, float oneSpacing);

} // namespace sculpt
