// Thinning to a Poisson disc: as many of the points as can stand with no two of them closer than a distance, each of
// them where it was (process/README 11.4). What resampling is to surfaces, this is to measurements.
#pragma once

#include "core/base/progress.h"
#include "core/surfel/surfel.h"

namespace process {

/// True for each point that goes. Points are taken in an order by chance, the same for the same positions whatever the
/// order of the list; where normals are oriented, points of two sides of a wall do not see each other. Masked ones
/// (mask 1) stay, and count first. REQUIRES: spacing > 0. Throws base::Cancelled.
std::vector<std::uint8_t> thinned(const surfel::SurfelList& points, float spacing, const base::Progress& progress = {});

} // namespace process
