// Rows of points along the borders of faces, as far apart as samples are there: who draws them first has a surface that
// ends where its faces do. Of samples by chance the outermost lie up to a spacing from the border, and what the
// off-centre limit makes of these is a nibbled rim (mesh/README 8.3).
//
// Borders are parted at their corners, which have a point each. Loops shorter than some spacings have none: triangles
// that hang together with nothing, holes that close.
#pragma once

#include "core/mesh/faces/face_draws.h"

#include <functional>

namespace mesh {

/// Of samples at a place on a triangle.
using SpacingOnFaces = std::function<double(const base::Vec3d& place, std::uint32_t triangle)>;

/// In the order of the borders. Throws base::Cancelled.
std::vector<FacePoint> borderRows(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                                  const SpacingOnFaces& spacing);

} // namespace mesh
