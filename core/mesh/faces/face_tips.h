// Fans that end in a tip: around the apex of a cone faces look in all directions, and their mean along the axis, which
// is the normal of none of them. Blended into faces as long as the cone it tilts all samples of its side.
#pragma once

#include "core/mesh/faces/face_topology.h"

#include <cstdint>

namespace mesh {

/// 1 for each fan all around a vertex with a face that turns from its normal by more than 10 degrees and by more than
/// any of its faces do from those across the far edges: what is bent all over turns as much there.
std::vector<std::uint8_t> tipFans(const FaceTopology& topology, std::span<const base::Vec3f> fanNormals);

} // namespace mesh
