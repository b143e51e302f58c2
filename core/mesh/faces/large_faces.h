// Points on faces so large that vertices kept as samples leave them empty: scans whose holes somebody closed with a few
// large triangles, flat sides of statues (mesh/README 8.2).
#pragma once

#include "core/mesh/faces/face_points.h"

namespace mesh {

/// Points on triangles whose longest side is more than four times the median spacing of the vertices, about that
/// spacing from each other and no nearer than 0.7 of it to any vertex. None where there are no such triangles, or where
/// they are so large that more points would come than there are vertices: those do not sample these faces.
std::vector<FacePoint> pointsOnLargeFaces(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                                          const base::Progress& progress = {});

} // namespace mesh
