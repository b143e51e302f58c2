// Do normals that came with points agree on a side? Some programs write the normals of planes, all of them into one
// half of space, and nothing in the file says so: taken for the outside, half of a body's edges are torn.
#pragma once

#include "core/process/estimation/cloud_normals.h"

namespace process {

/// The share of positions beside which, in their own sheet, a neighbour's normal is opposite (contradictions.h). Of up
/// to some 100,000 positions.
double opposedShare(const Cloud& cloud, const NeighbourTable& links, std::span<const base::Vec3f> normals);

/// Turns unit normals where a clear share does not agree and most of that can be mended. True if it did.
bool makeAgree(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
               const base::Progress& progress = {});

} // namespace process
