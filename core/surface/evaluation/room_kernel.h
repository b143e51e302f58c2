// The vectorised part of looking for room. Internal to the room of surfaces.
#pragma once

#include "core/surface/evaluation/self_room.h"

namespace surface {

struct RoomInput {
    const float* cluster; ///< whose surfels look around
    base::Box3f box;      ///< of their places
    ClusterSpan around;   ///< all clusters with surfels within ring + clear of the box
    const RoomQuestion& question;
};

constexpr std::size_t roomRows = 6; ///< that `roomKernel` picks into

/// A bit for each of the 16 surfels that is crowded or has room; lanes past the end say anything. `scratch` has room
/// for roomRows.
unsigned roomKernel(const RoomInput& in, float* scratch);

} // namespace surface
