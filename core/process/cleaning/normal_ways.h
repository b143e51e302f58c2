// Normals by other ways than the plane of 18 neighbours (estimation/cloud_normals.h): from a quadric, which follows
// bends, and from the rows and columns in which a scanner measured.
#pragma once

#include "core/process/neighbours/knn.h"

#include <optional>

namespace process {

/// Unit normals without a meaningful sign, one per position: of the quadric through 24 neighbours, at the position.
std::vector<base::Vec3f> quadricNormals(const Cloud& cloud, const base::Progress& progress = {});

/// From the neighbours along row and column of an ordered grid, told by the attributes `row` and `column`; across a
/// step in depth the nearer neighbour counts alone. One per point of the list; zero where a point has too few beside
/// it. Nothing where the points are not an ordered grid. In parallel, the same bits at any thread count.
std::optional<std::vector<base::Vec3f>> gridNormals(const surfel::SurfelList& points,
                                                    const base::Progress& progress = {});

} // namespace process
