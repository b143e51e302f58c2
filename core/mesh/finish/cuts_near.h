// Triangles that cut each other, looked for near some vertices only. Internal to the room.
#pragma once

#include "core/mesh/mesh.h"

#include <span>
#include <utility>

namespace mesh {

/// Pairs of triangles within some two cells of those vertices that cut each other; those without area with themselves.
std::vector<std::pair<std::uint32_t, std::uint32_t>> cutsNear(const Mesh& mesh, std::span<const std::uint32_t> around,
                                                              double cell);

} // namespace mesh
