// How many triangles each edge has, where a mesh may still be torn or folded and no Triangulation can be trusted.
// Internal to the room.
#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace mesh {

/// By the edge's ends, the smaller number first.
using EdgeCounts = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

inline EdgeCounts edgeCounts(std::span<const Triangle> triangles) {
    EdgeCounts out;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++out[std::minmax(t[k], t[(k + 1) % 3])];
    return out;
}

/// By vertex, of `count`: is it at the end of an edge with one triangle?
inline std::vector<bool> endsOfOpenEdges(std::span<const Triangle> triangles, std::size_t count) {
    std::vector<bool> out(count, false);
    for (const auto& [edge, of] : edgeCounts(triangles))
        if (of == 1)
            out[edge.first] = out[edge.second] = true;
    return out;
}

} // namespace mesh
