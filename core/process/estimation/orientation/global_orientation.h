// Orientation by agreement of the whole: pieces of the surface whose signs are certain in themselves are turned so that
// winding numbers are those on the surface of a body (process/README 2.4).
//
// Where the spanning tree carries one wrong decision from a doubtful bridge to all that hangs on it, here every piece
// is judged by all the others, near and far. In parallel, the same bits at any thread count.
#pragma once

#include "core/process/estimation/cloud_normals.h"

namespace process {

/// As `orient` (cloud_normals.h): flips unit normals in place; false where the surface has no two sides.
bool orientGlobally(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
                    const base::Progress& progress = {}, Sides given = Sides::Unknown);

/// One per position, true where an orientation is in doubt: where more than a quarter of what its neighbours
/// say, weighted by how certain they are, contradicts it.
std::vector<std::uint8_t> doubtfulSigns(const Cloud& cloud, const NeighbourTable& links,
                                        std::span<const base::Vec3f> normals, const base::Progress& progress = {});

} // namespace process
