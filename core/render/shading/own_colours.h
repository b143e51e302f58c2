// Whether a model's colours are worth showing.
#pragma once

#include "core/render/shading/shading_table.h"
#include "core/tree/surfel_tree.h"

namespace render {

/// It has colours, and they are not all the same: many programs write black or white where they know none. Cost: up to
/// the first surfel that differs.
bool hasOwnColours(const tree::SurfelTree& tree);

/// What a model is shown in where nobody chose: its own colours, of Gaussian splats as they were taken, since light is
/// in them already; else the matcap.
Shading usualShading(const tree::SurfelTree& tree);

} // namespace render
