// Whether a part of a cloud is enough to tell what its points are: outliers and duplicates are told by neighbours, by
// theirs, and by what these see.
#pragma once

#include "core/process/neighbours/knn.h"

namespace process {

/// Of a part that is all there is within `low` and `high` in x and y: for each position, by how much that is too narrow
/// for what is told of it to be what is told of the whole; 0 where it is not. Islands, and swarms of more than a
/// twentieth of all, may be larger than any part. Throws base::Cancelled.
std::vector<float> missingSight(const Cloud& part, const float (&low)[2], const float (&high)[2],
                                const base::Progress& progress = {});

} // namespace process
