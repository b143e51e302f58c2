// Fields that grow and shrink by a length along the surface, and their borders (selection/README 5).
//
//     grown(i) = max v(j) over all j with d(i, j) <= length        shrunk = 1 - grown of 1 - v
//
// d is the length of the shortest way over links (links.h). Soft values go along: each keeps its distance to the next.
// Cost: what lies within `length` of where the field varies, and a glance at every block.
#pragma once

#include "core/base/progress.h"
#include "core/selection/field.h"
#include "core/surface/surface.h"

namespace selection {

tree::SurfelTree grown(const surface::Surface& surface, Field field, double length,
                       const base::Progress& progress = {});
tree::SurfelTree shrunk(const surface::Surface& surface, Field field, double length,
                        const base::Progress& progress = {});

/// Of the selected surfels those that are linked with one that is not.
tree::Selection borderOf(const surface::Surface& surface, Field field = Field::Selection);

} // namespace selection
