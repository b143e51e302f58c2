// How finely faces are sampled already by their vertices.
#pragma once

#include "core/mesh/faces/face_topology.h"

namespace mesh {

/// Spacing of the vertices as samples: the side of a square as large as a vertex's share of the faces around it,
/// averaged with its neighbours'. At a border the share is that of a full turn. Zero for vertices without faces.
std::vector<float> vertexSpacings(const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// Whether the vertices may stand for the faces: they resolve the shape, are no coarser than some 20,000 of them, and
/// local spacing differs by less than 2.5 times between the 5th and the 95th percentile (mesh/README 8.2).
bool sampleWell(const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// Is there a convex one of less than 60 degrees among the edges? Towards it walls get thinner than any samples are
/// apart.
bool hasBlades(const FaceTopology& topology, std::span<const SharpEdge> edges);

} // namespace mesh
