#include "core/mesh/delaunay/kept_closed.h"

#include <algorithm>

namespace mesh {

bool KeptClosed::mayCollapse(std::span<const std::uint32_t> ring, std::uint32_t vertex, std::uint32_t into) {
    std::vector<Triangle> made;
    for (const std::uint32_t f : ring) {
        if (held(f))
            return false;
        Triangle t = m_mesh.corners(f);
        if (std::count(t.begin(), t.end(), into) > 0)
            continue;
        std::replace(t.begin(), t.end(), vertex, into);
        made.push_back(t);
    }
    return allows(made, ring);
}

} // namespace mesh
