// Which edges hang together at their ends.
#pragma once

#include "core/base/disjoint_sets.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace mesh {

/// Of each edge the first one of its chain, or loop. `Edge`: has `ends`, as numbers of places.
template <class Edge>
std::vector<std::uint32_t> chainsOf(const std::vector<Edge>& edges) {
    base::DisjointSets sets(edges.size());
    std::unordered_map<std::uint32_t, std::uint32_t> first; // edge at a place
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        for (const std::uint32_t end : edges[e].ends)
            sets.join(first.emplace(end, e).first->second, e);
    std::vector<std::uint32_t> out(edges.size());
    for (std::uint32_t e = 0; e < out.size(); ++e)
        out[e] = sets.find(e);
    return out;
}

} // namespace mesh
