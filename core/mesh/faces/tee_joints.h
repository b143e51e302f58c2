// Corners that lie on sides of other faces (T-junctions): programs that cut faces one by one leave them, and without
// them what is whole falls apart into pieces with borders (mesh/README 8.1).
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace mesh {

/// For edges with places of others inside: these, from the edge's lower end to its higher one.
using TeeJoints = std::unordered_map<std::uint64_t, std::vector<std::uint32_t>>;

/// `edges`: those of the boundary, as lower place << 32 | higher place; their ends are looked for on the others.
/// `tolerance`: distance from an edge up to which a place is on it. Time: some lookups for each mean edge's length.
TeeJoints teeJoints(std::span<const base::Vec3f> positions, std::span<const std::uint64_t> edges, double tolerance);

} // namespace mesh
