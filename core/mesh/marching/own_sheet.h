// Where near sheets meet: the place on one of them, told apart by the way it faces. Internal to the room.
//
// f as it is tells of the sheet whose surfel is nearest, and has steps where that changes. Seen as one sheet alone, by
// a normal, it has none; which surfels count then depends on the normal that was asked for, so the answer is a place
// whose normal leads to itself.
#pragma once

#include "core/mesh/marching/edge_walk.h"

#include <optional>

namespace mesh {

struct SheetPoint {
    base::Vec3d position;
    base::Vec3f normal; ///< by which the sheet is asked for there
};

/// From `start`, onto the sheet that faces about as `normal` does; not beyond its rim, and no further than `farthest`.
std::optional<SheetPoint> ontoOwnSheet(const surface::Surface& surface, const WalkSetting& setting,
                                       const base::Vec3d& start, const base::Vec3f& normal, double farthest);

} // namespace mesh
