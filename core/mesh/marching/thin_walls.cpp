#include "core/mesh/marching/thin_walls.h"

#include "core/base/parallel.h"
#include "core/base/scratch.h"
#include "core/mesh/surface_traits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesh {

namespace {

constexpr std::size_t looked = 12; ///< surfels: some of the sheet across, where that is nearer than a spacing
constexpr float opposed = -0.5f;   ///< cosine
constexpr std::size_t few = 200;   ///< of so many surfels one may be a stray
constexpr float thinnest = 0.4f;   ///< spacings: tips of blades are always thinner
/// Squares of cubes in walls, to a surfel of the model and at all: more take too long.
constexpr double mostSquares = 4, enoughSquares = 1.5e6;

/// How far the nearest sheet is that looks the other way, in spacings; infinity where none is within one.
float wallAt(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int slot, float spacing,
             std::vector<tree::Neighbour>& near) {
    const base::Vec3f x = block.position(slot), n = block.normal(slot);
    tree.nearest(x, looked, near, 1.5f * spacing); // beside by a spacing, across by another
    float out = std::numeric_limits<float>::infinity();
    for (const tree::Neighbour& each : near) {
        if (!(dot(n, each.block->normal(each.slot)) < opposed))
            continue;
        const base::Vec3f way = each.block->position(each.slot) - x;
        const float height = std::abs(dot(way, n));
        if (height < spacing && lengthSq(way) - height * height < spacing * spacing)
            out = std::min(out, height / spacing);
    }
    return out;
}

/// fn(number, block, slot, spacing) for all surfels, in the tree's order by number; blocks in parallel.
template <class Fn>
void forSurfels(const surface::Surface& surface, const Fn& fn) {
    const double perUnit = SurfaceTraits(surface).spacingsPerUnit;
    const tree::SurfelTree& tree = surface.tree();
    std::vector<std::size_t> first(tree.blockCount() + 1, 0);
    for (std::uint32_t b = 0; b < tree.blockCount(); ++b)
        first[b + 1] = first[b] + static_cast<std::size_t>(tree.block(b)->size());
    base::parallelFor(tree.blockCount(), 1, [&](std::size_t number) {
        const surfel::BlockPtr block = tree.block(static_cast<std::uint32_t>(number));
        for (int slot = 0; slot < block->size(); ++slot)
            fn(first[number] + static_cast<std::size_t>(slot), *block, slot,
               static_cast<float>(perUnit * double(block->support(slot))));
    });
}

/// The thinnest that is looked at, in spacings. A cube in a wall has a side of at least half of it: (2 / wall)^2
/// squares to each surfel there.
float leastOf(std::size_t thin, std::size_t surfels) {
    const double squares = std::max(mostSquares * static_cast<double>(surfels), enoughSquares);
    return std::clamp(static_cast<float>(2 * std::sqrt(static_cast<double>(thin) / squares)), thinnest, 1.0f);
}

} // namespace

std::vector<float> thinWalls(const surface::Surface& surface) {
    if (!SurfaceTraits(surface).sided)
        return {};
    static base::Scratch<std::vector<tree::Neighbour>> scratch;
    std::vector<float> out(surface.tree().size());
    forSurfels(surface, [&](std::size_t number, const surfel::SurfelBlock& block, int slot, float spacing) {
        const auto near = scratch.take();
        out[number] = wallAt(surface.tree(), block, slot, spacing, *near);
    });
    const auto thin =
        static_cast<std::size_t>(std::count_if(out.begin(), out.end(), [](float wall) { return std::isfinite(wall); }));
    if (thin * few <= out.size())
        return {};
    const float least = leastOf(thin, out.size());
    forSurfels(surface, [&](std::size_t number, const surfel::SurfelBlock&, int, float spacing) {
        out[number] = std::max(out[number], least) * spacing;
    });
    return out;
}

} // namespace mesh
