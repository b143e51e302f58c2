// Where faces carry more shape than samples a piece's spacing apart can show: small roundings, lips and teeth of a
// statue whose file has finer triangles there (mesh/README 8.3).
//
// Cells of an octree, of one spacing first, are halved while normals in them turn by more than a spacing may, and
// triangles in them are no larger than half of them. What is coarse in the file stays coarse, and what is fine but
// flat. Axes count, not normals, and patches one by one: neither walls behind nor edges that stay sharp are a turn.
#pragma once

#include "core/mesh/faces/face_topology.h"
#include "core/mesh/faces/near_spacings.h"

#include <span>
#include <vector>

namespace mesh {

/// Places that ask for less than the spacing of their piece; none where samples that far apart will do. `spacings`: of
/// each piece, > 0; `patches`: of each triangle the one between edges that stay sharp. The same at any thread count.
/// Throws base::Cancelled.
std::vector<SpacedPlace> detailedPlaces(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                                        std::span<const double> spacings, std::span<const std::uint32_t> patches);

} // namespace mesh
