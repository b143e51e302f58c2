// The edges of triangles, by sorting: who uses which, and in which direction. Internal to what asks for topology.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

/// A triangle's side from its corner `corner % 3` to the next; `corner` counts 3 per triangle.
struct EdgeUse {
    std::uint32_t low = 0, high = 0; ///< its vertices
    std::uint32_t corner = 0;
    bool forward = true; ///< runs from `low` to `high`

    std::uint32_t face() const { return corner / 3; }
    std::uint32_t next() const { return corner % 3 == 2 ? corner - 2 : corner + 1; }
};

/// A triangle that names a vertex twice has no sides.
constexpr bool isProper(const Triangle& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// All sides of all proper triangles; uses of the same edge stand together, in the order of their triangles.
/// REQUIRES: fewer than 2^32 / 3 triangles.
std::vector<EdgeUse> edgeUses(std::span<const Triangle> triangles);

/// fn(uses) for every edge, uses being a span of one entry per triangle at it.
template <class Fn>
void forEdges(std::span<const EdgeUse> uses, const Fn& fn) {
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
        while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high)
            ++end;
        fn(uses.subspan(begin, end - begin));
    }
}

} // namespace mesh
