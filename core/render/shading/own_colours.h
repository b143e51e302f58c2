// Whether a model's colours are worth showing.
#pragma once

#include "core/tree/surfel_tree.h"

namespace render {

/// It has colours, and they are not all the same: many programs write black or white where they know none. Cost: up to
/// the first surfel that differs.
bool hasOwnColours(const tree::SurfelTree& tree);

} // namespace render
