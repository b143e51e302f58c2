// Finds the point on one of several near sheets, told apart by the way it faces (mesh/README 3.12). Internal to the
// room.
//
// Plain f describes the sheet of the nearest surfel and has steps where that changes. Restricted to one sheet by a
// normal, it has none; but which surfels count depends on the normal asked for, so we look for a point whose own normal
// leads back to it.
#pragma once

#include "core/mesh/surface_traits.h"

#include <optional>

namespace mesh {

struct SurfacePoint {
    base::Vec3d position;
    base::Vec3f normal; ///< unit gradient; from ontoOwnSheet the normal that selects the sheet there
};

/// Projects `start` onto the sheet that faces roughly along `normal`; nothing beyond the boundary or further than
/// `farthest`.
std::optional<SurfacePoint> ontoOwnSheet(const surface::Surface& surface, const SurfaceTraits& traits,
                                         const base::Vec3d& start, const base::Vec3f& normal, double farthest);

} // namespace mesh
