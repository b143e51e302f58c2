// How large cubes and triangles are unless somebody says so.
#pragma once

#include "core/tree/surfel_tree.h"

namespace mesh {

/// The median spacing; more where the surface would have more than 25 such squares to a surfel (4 where there are many
/// surfels), because most surfels lie in places that are much denser than the rest, as on a screw that was joined to a
/// house. Fewer than 7 surfels have what their supports tell; 0 for none.
double usualCell(const tree::SurfelTree& tree);

} // namespace mesh
