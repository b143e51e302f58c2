// Dabs that do not pile up: each works on the surface that the stroke began on, and of all that touch a surfel the one
// that takes it farthest counts.
//
//     p_k = tool_k(p_0),     p = p_j with the largest |p_j - p_0|           normals go with their positions
//
// Masks, colours and further attributes are compared likewise, each by itself. A surfel's p_0 stands in the same slot
// of the same block of the first version: edits that only change keep the numbering.
#pragma once

#include "core/tree/surfel_tree.h"

namespace sculpt {

/// What `edit`, made on `start`, changes in `now`. REQUIRES: `now` came from `start` by edits that only change; so does
/// `edit`.
tree::Edit farthest(const tree::SurfelTree& start, const tree::SurfelTree& now, const tree::Edit& edit);

} // namespace sculpt
