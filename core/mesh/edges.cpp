#include "core/mesh/edges.h"

#include <algorithm>

namespace mesh {

std::vector<EdgeUse> edgeUses(std::span<const Triangle> triangles) {
    std::vector<EdgeUse> out;
    out.reserve(3 * triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const Triangle& t = triangles[f];
        if (!isProper(t))
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            out.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(3 * f + k), a < b});
        }
    }
    std::sort(out.begin(), out.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
    });
    return out;
}

} // namespace mesh
