// What faces tell of vertices that are kept as samples: normals, supports, colours, which of them nobody sees.
#pragma once

#include "core/mesh/faces/face_paint.h"
#include "core/mesh/faces/face_topology.h"
#include "core/surface/definition.h"

namespace mesh {

/// Normals where they have none, and turned where those of a closed piece look inwards, by most of its area. True where
/// own normals had to be turned.
bool completeVertices(surfel::SurfelList& vertices, const FaceTopology& topology,
                      std::span<const base::Vec3f> positions);

void paintVertices(surfel::SurfelList& vertices, const FacePaint& paint);

/// Sets those of nothing but faces inside of the solid.
void findInner(const FaceTopology& topology, std::vector<std::uint8_t>& gone);

/// Supports by the edges about each; of those without faces, that of the nearest with some.
std::vector<float> vertexSupports(const surfel::SurfelList& kept, const FaceTopology& topology,
                                  std::span<const base::Vec3f> positions, const surface::SurfaceDefinition& definition);

} // namespace mesh
