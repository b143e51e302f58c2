// What the ways to orient normals share: signs that were found as sets of points with parities are judged, and taken.
// Inside this folder.
#pragma once

#include "core/base/disjoint_sets.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/normal_links.h"

namespace process {

/// Is there a seam, along which certain edges contradict the signs that the trees gave? Then the surface has no two
/// sides (process/README 2.2).
bool hasSeam(base::ParitySets& trees, const NormalLinks& links, std::size_t points);

/// Turns normals as the trees say, and each component so that it looks outwards (process/README 2.3).
void takeSigns(base::ParitySets& trees, const Cloud& cloud, std::span<base::Vec3f> normals, Sides given,
               const base::Progress& progress);

} // namespace process
