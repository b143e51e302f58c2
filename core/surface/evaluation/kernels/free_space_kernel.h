// The vectorised part of the free-space test. Internal to the room of surfaces.
#pragma once

#include "core/surface/evaluation/free_space.h"

namespace surface {

struct FreeSpaceInput {
    const float* cluster; ///< whose surfels look around
    base::Box3f box;      ///< of their places
    ClusterSpan around;   ///< all clusters with surfels within ring + clear of the box
    const FreeSpaceQuery& query;
};

constexpr std::size_t freeSpaceRows = 6; ///< that `freeSpaceKernel` picks into

/// A bit for each of the 16 surfels that is crowded or has free space; lanes past the end say anything. `scratch`
/// holds freeSpaceRows.
unsigned freeSpaceKernel(const FreeSpaceInput& in, float* scratch);

} // namespace surface
