#include "core/mesh/marching/thin_walls.h"

#include "core/base/parallel.h"
#include "core/mesh/surface_traits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesh {

namespace {

constexpr std::size_t looked = 12; ///< surfels: some of the sheet across, where that is nearer than a spacing
constexpr float opposed = -0.5f;   ///< cosine
constexpr std::size_t few = 200;   ///< of so many surfels one may be a stray

/// How far the nearest sheet is that looks the other way; infinity where none is within a spacing.
float wallAt(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int slot, float spacing,
             std::vector<tree::Neighbour>& near) {
    const base::Vec3f x = block.position(slot), n = block.normal(slot);
    tree.nearest(x, looked, near);
    float out = std::numeric_limits<float>::infinity();
    for (const tree::Neighbour& each : near) {
        if (!(dot(n, each.block->normal(each.slot)) < opposed))
            continue;
        const base::Vec3f way = each.block->position(each.slot) - x;
        const float height = std::abs(dot(way, n));
        if (height < spacing && lengthSq(way) - height * height < spacing * spacing)
            out = std::min(out, std::max(height, thinnestWall * spacing));
    }
    return out;
}

} // namespace

std::vector<float> thinWalls(const surface::Surface& surface) {
    const SurfaceTraits traits(surface);
    if (!traits.closed)
        return {};
    const tree::SurfelTree& tree = surface.tree();
    std::vector<std::size_t> first(tree.blockCount() + 1, 0);
    for (std::uint32_t b = 0; b < tree.blockCount(); ++b)
        first[b + 1] = first[b] + static_cast<std::size_t>(tree.block(b)->size());
    std::vector<float> out(first.back());
    base::parallelFor(tree.blockCount(), 1, [&](std::size_t number) {
        thread_local std::vector<tree::Neighbour> near;
        const surfel::BlockPtr block = tree.block(static_cast<std::uint32_t>(number));
        for (int slot = 0; slot < block->size(); ++slot) {
            const auto spacing = static_cast<float>(traits.spacingsPerUnit * double(block->support(slot)));
            out[first[number] + static_cast<std::size_t>(slot)] = wallAt(tree, *block, slot, spacing, near);
        }
    });
    const auto thin = std::count_if(out.begin(), out.end(), [](float wall) { return std::isfinite(wall); });
    if (static_cast<std::size_t>(thin) * few <= out.size())
        out.clear();
    return out;
}

} // namespace mesh
