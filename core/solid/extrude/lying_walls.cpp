#include "core/solid/extrude/lying_walls.h"

#include "core/base/parallel.h"
#include "core/surface/definition.h"

namespace solid {

using base::Vec3f;

/// Does a surfel of the tree lie there and face the other way?
static bool facedAt(const tree::SurfelTree& tree, const surfel::Surfel& s) {
    constexpr float beside = 0.75f, above = 0.2f, opposite = -0.9f; // in spacings, of which no place is 0.6 from all
    constexpr std::size_t looked = 6;
    const float spacing = s.support * static_cast<float>(surface::spacingOfUnit);
    std::vector<tree::Neighbour> near;
    tree.nearest(s.position, looked, near, beside * spacing);
    return std::ranges::any_of(near, [&](const tree::Neighbour& each) {
        return dot(each.block->normal(each.slot), s.normal) < opposite &&
               std::abs(dot(each.block->position(each.slot) - s.position, s.normal)) < above * spacing;
    });
}

static std::vector<std::uint8_t> facedIn(const tree::SurfelTree& tree, std::span<const surfel::Surfel> surfels) {
    std::vector<std::uint8_t> out(surfels.size());
    base::parallelFor(out.size(), 64, [&](std::size_t i) { out[i] = facedAt(tree, surfels[i]); });
    return out;
}

void takeLying(const surface::Surface& surface, const Part& part, const tree::SurfelTree& rest,
               surfel::SurfelList& walls, std::vector<std::uint8_t>& covered) {
    covered.assign(surface.tree().size(), 0);
    const std::vector<std::uint8_t> lying = facedIn(rest, walls.items);
    surfel::SurfelList left, gone;
    left.layout = gone.layout = walls.layout;
    for (std::size_t i = 0; i < walls.size(); ++i)
        (lying[i] ? gone : left).append(walls.items[i], walls.extraOf(i));
    if (gone.size() == 0)
        return;
    covered = facedIn(tree::SurfelTree::build(gone), surface.tree().surfels().items);
    for (std::size_t i = 0; i < covered.size(); ++i)
        covered[i] = covered[i] && !part.holds(i);
    walls = std::move(left);
}

} // namespace solid
