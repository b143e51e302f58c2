#include "core/sculpt/fold_strays.h"

#include "core/tree/nearest_together.h"

#include <algorithm>

namespace sculpt {

using base::Vec3f;
using surfel::SurfelBlock;

/// Nearest surfels that are asked, the surfel itself among them, and the mean cosine below which they contradict it.
constexpr std::size_t asked = 13;
constexpr float contradiction = -0.25f;
/// A surfel's own sheet: how many bear it, how near in spacings, the least cosine between two normals, and the sine of
/// how steeply one may stand above the other.
constexpr int bearers = 3;
constexpr float reach = 2.2f, sameSheet = 0.17f, steepest = 0.866f;

FoldStrays::FoldStrays(tree::SurfelTree now, tree::SurfelTree first)
    : m_now(std::move(now)), m_first(std::move(first)) {}

static bool contradict(std::span<const tree::Neighbour> near, const Vec3f& normal) {
    float sum = -1; // of the surfel with itself
    for (const tree::Neighbour& each : near)
        sum += dot(normal, each.block->normal(each.slot));
    return sum < contradiction * static_cast<float>(asked - 1);
}

/// Do enough of its own sheet stand around the surfel at x?
static bool isBorne(const tree::SurfelTree& tree, const Vec3f& x, const Vec3f& normal, float spacing) {
    const float far = reach * spacing;
    int count = -1; // itself
    tree.forBlocksInBall(x, far, [&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size() && count < bearers; ++slot) {
            const Vec3f way = block.position(slot) - x, n = block.normal(slot);
            const float least = steepest * length(way);
            count += dot(way, way) < far * far && dot(normal, n) > sameSheet && std::abs(dot(way, normal)) <= least &&
                     std::abs(dot(way, n)) <= least;
        }
    });
    return count >= bearers;
}

/// Was the surfel of a version that is nearest to x one?
static bool strayBefore(const tree::SurfelTree& first, const Vec3f& x, float spacing) {
    std::vector<tree::Neighbour> near;
    first.nearest(x, 1, near);
    if (near.empty())
        return false;
    const Vec3f place = near[0].block->position(near[0].slot), normal = near[0].block->normal(near[0].slot);
    first.nearest(place, asked, near);
    return contradict(near, normal) && !isBorne(first, place, normal, spacing);
}

/// Do all normals about a block, as far as any of its nearest may be, belong to one sheet? So it is nearly everywhere.
static bool facesOneWay(const tree::SurfelTree& tree, const SurfelBlock& block) {
    const base::Box3f box = block.box();
    std::vector<const SurfelBlock*> near;
    tree.forBlocksInBall(box.centre(), box.diagonal(),
                         [&](std::uint32_t, const SurfelBlock& each) { near.push_back(&each); });
    const auto forNormals = [&](const auto& fn) {
        for (const SurfelBlock* each : near)
            for (int slot = 0; slot < each->size(); ++slot)
                fn(each->normal(slot));
    };
    Vec3f sum;
    forNormals([&](const Vec3f& n) { sum += n; });
    const Vec3f axis = normalized(sum);
    float least = 1;
    forNormals([&](const Vec3f& n) { least = std::min(least, dot(axis, n)); });
    constexpr float half = 0.77f; // cosine of half the angle between two that are alike
    static_assert(2 * half * half - 1 > sameSheet);
    return least > half;
}

FoldStrays::Slots FoldStrays::contradicted(const SurfelBlock& block, const Slots& slots) const {
    std::vector<int> all;
    std::vector<Vec3f> places;
    for (int slot = 0; slot < block.size(); ++slot)
        if (slots[static_cast<std::size_t>(slot)] && block.mask(slot) < 1)
            all.push_back(slot), places.push_back(block.position(slot));
    Slots out;
    tree::NearestTogether(m_now, asked).forEach(places, [&](std::size_t i, std::span<const tree::Neighbour> near) {
        out.set(static_cast<std::size_t>(all[i]), contradict(near, block.normal(all[i])));
    });
    return out;
}

FoldStrays::Slots FoldStrays::in(const SurfelBlock& block, const Slots& slots, const SourceOf& sourceOf) const {
    if (!m_now.layout()->normals || !m_now.layout()->oriented || slots.none() || facesOneWay(m_now, block))
        return {};
    Slots out = contradicted(block, slots);
    for (int slot = 0; slot < block.size(); ++slot) {
        if (!out[static_cast<std::size_t>(slot)])
            continue;
        const CrumbSource source = sourceOf(block, slot);
        const float spacing = std::max(source.spacing, source.made);
        out.set(static_cast<std::size_t>(slot), !isBorne(m_now, block.position(slot), block.normal(slot), spacing) &&
                                                    !strayBefore(m_first, source.origin, spacing));
    }
    return out;
}

} // namespace sculpt
