// The surfels well under the brush, as resampling wants them.
#pragma once

#include "core/sculpt/tools/brush.h"
#include "core/tree/selection.h"

namespace sculpt {

/// Those with a weight above 0 that lie within `radius` of the brush's centre.
tree::Selection inside(const tree::SurfelTree& tree, const Brush& brush, float radius);
/// Of these. On one thread.
tree::Selection inside(const tree::SurfelTree& tree, const Brush& brush, float radius, const tree::Selection& among);

} // namespace sculpt
