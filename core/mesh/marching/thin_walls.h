// Where walls, and gaps between walls, are thinner than surfels are apart: nodes of cubes as large as these do not see
// them (mesh/README 3.17). Internal to the room.
#pragma once

#include "core/surface/surface.h"

#include <vector>

namespace mesh {

/// Of each surfel in the tree's order: how far away the sheet is that looks the other way, where that is less than a
/// spacing; at least 0.4 spacings, more of large models that are thin in many places, so that cubes do not become too
/// many; infinity where there is none. Empty where surfels have none but for a few, and where the surface bounds no
/// solid.
std::vector<float> thinWalls(const surface::Surface& surface);

} // namespace mesh
