// How thick the body is behind places on its faces.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_points.h"

namespace mesh {

/// Distance to the wall behind, for points spread over the faces, as far as a few of their own spacings; infinity
/// beyond. Where two flanks run together to a sharp edge there is none. `spacings`: of these points, of each piece.
/// Throws base::Cancelled.
std::vector<float> wallsBehind(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                               std::span<const FacePoint> points, std::span<const double> spacings,
                               const base::Progress& progress = {});

} // namespace mesh
