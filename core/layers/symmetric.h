// What layers hold where a model was made symmetric (layers/README 3).
#pragma once

#include "core/base/plane.h"
#include "core/layers/layer_words.h"

namespace layers {

/// The words of `after`, whose surfels below the plane are images of those above it that came with their words. It then
/// is symmetric at every strength. In parallel; a model that lacks the words of the stack comes back as it is.
tree::SurfelTree symmetric(const tree::SurfelTree& after, const Stack& stack, const base::Plane& plane);

} // namespace layers
