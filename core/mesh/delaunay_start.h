// Points of the surface that a restricted Delaunay triangulation begins with, and those it turned out to need.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/restricted.h"

namespace mesh {

using SizeField = std::function<double(const base::Vec3d&)>;

/// The traced rims, as chains of rim points at most a size apart.
std::vector<RimChain> rimChains(const surface::Surface& surface, const SizeField& size,
                                const base::Progress& progress = {});

/// Feet of surfels, about a size apart from each other and from `taken`, that leave no surfel's foot further away than
/// a size. Of surfels only whose feet are surface (surface/intersect.h).
std::vector<base::Vec3d> spreadPoints(const surface::Surface& surface, const SizeField& size,
                                      std::span<const base::Vec3d> taken, const base::Progress& progress = {});

/// Feet of surfels that lie further than `reach` sizes from every vertex that triangles use.
std::vector<base::Vec3d> uncoveredFeet(const surface::Surface& surface, const SizeField& size, const Mesh& mesh,
                                       double reach);

} // namespace mesh
