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

/// Leaves out vertices of nothing but faces inside of the solid.
void leaveOutInner(surfel::SurfelList& vertices, const FaceTopology& topology);

/// Supports by the edges about each; 0 for those without faces.
std::vector<float> vertexSupports(const surfel::SurfelList& kept, const FaceTopology& topology,
                                  std::span<const base::Vec3f> positions, const surface::SurfaceDefinition& definition);

} // namespace mesh
