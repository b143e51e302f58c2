// Corners on the boundary that programs computed twice, with another rounding each time.
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mesh {

/// Joins places on the boundary that are the same but for round-off: the first of them stands for all. False where
/// there are none. `places`: of each corner, the first one there; `edges`, `boundary`: of it, and their places.
bool joinBoundary(std::vector<std::uint32_t>& places, std::span<const base::Vec3f> positions, double tolerance,
                  const std::vector<std::uint64_t>& edges, const std::vector<std::uint32_t>& boundary);

} // namespace mesh
