// Keeps triangles as close to the surface as asked for (mesh/README 3.11). Internal to the room.
#pragma once

#include "core/mesh/finish/untangle.h"
#include "core/surface/surface.h"

namespace mesh {

/// By place, the middle of a triangle: is the surface further than `tolerance`, by f over its slope, or none there?
std::vector<std::uint8_t> farTriangles(const surface::Surface& surface, std::span<const base::Vec3d> centres,
                                       double tolerance);

/// Puts the corners of triangles that are too far away back to where they were, again and again, but of those that were
/// so before. Returns how many vertices went back.
std::size_t holdTolerance(Mesh& mesh, const surface::Surface& surface, const VertexPlaces& before, double tolerance);

} // namespace mesh
