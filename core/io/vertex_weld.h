// Corners of triangles that stand at exactly the same place become one point.
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace io {

struct Welded {
    std::vector<base::Vec3d> points;    ///< in the order in which their first corner comes
    std::vector<std::uint32_t> corners; ///< the point of every corner
    std::vector<base::Vec3d> normals;   ///< sum of the cross products of their triangles: weighted by area; not unit
};

/// REQUIRES: three corners per triangle, fewer than 2^32 corners. Zero and negative zero are the same place.
Welded weldTriangles(std::span<const base::Vec3d> corners);

} // namespace io
