// Triangles of a mesh that intersect, decided exactly (mesh/README 6.4). CGAL stays behind this header.
//
// Two triangles meet properly if they share only the vertices and the edge that they have in common; anything more,
// touching included, is an intersection. Triangles without area are ignored.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <span>
#include <utility>

namespace mesh {

/// Pairs of triangles, each with the smaller number first, in ascending order. Throws base::Cancelled.
std::vector<std::pair<std::uint32_t, std::uint32_t>> selfIntersections(const Mesh& mesh,
                                                                       const base::Progress& progress = {});
/// Of some triangles with each other.
std::vector<std::pair<std::uint32_t, std::uint32_t>>
selfIntersections(const Mesh& mesh, std::span<const std::uint32_t> among, const base::Progress& progress = {});

/// Of two triangles: true also where they are the same. REQUIRES: both have an area.
bool trianglesMeet(std::span<const base::Vec3d> positions, const Triangle& a, const Triangle& b);
/// Has a triangle no area, exactly?
bool isFlat(std::span<const base::Vec3d> positions, const Triangle& t);

} // namespace mesh
