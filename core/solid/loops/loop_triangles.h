// The first triangles of a patch: those over the corners of a polygon in space that have the least area, without folds
// where they can be had (solid/README 1.2, [Barequet95]).
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace solid {

/// size - 2 triangles, in the polygon's direction. `normals`: of the surface around, unit, at the corners. Time is the
/// cube of the number of corners. REQUIRES: at least 3.
std::vector<mesh::Triangle> trianglesOver(std::span<const base::Vec3d> polygon, std::span<const base::Vec3d> normals);

} // namespace solid
