// The order in which a batch of positions is evaluated: as it is, or along a Morton curve where that lets packets of
// them share what they read. Internal to the room.
#pragma once

#include "core/surface/surface.h"

namespace surface {

/// Box of some of the positions.
base::Box3f boxOf(std::span<const base::Vec3f> x, std::span<const std::uint32_t> which);

/// Indices of all positions: as they come, or along a Morton curve where most of some sampled packets of consecutive
/// ones lie about more of the surface than they pay for.
std::vector<std::uint32_t> packetOrder(const Surface& surface, std::span<const base::Vec3f> x, std::size_t packetSize);

} // namespace surface
