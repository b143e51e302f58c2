// A block of clay: a box with rounded edges and corners, sampled evenly in closed rows from the middle of its bottom
// over the walls to the middle of its top.
#pragma once

#include "core/surfel/surfel.h"

namespace process {

struct RoundedBox {
    double halfX = 0.78, halfY = 0.48, halfZ = 0.58; ///< outer half extents
    double rounding = 0.16;                          ///< radius of edges and corners, less than every half extent
};

/// `count` surfels with outward normals, exactly on the box.
surfel::SurfelList sampleBlock(const RoundedBox& box, std::size_t count);

} // namespace process
