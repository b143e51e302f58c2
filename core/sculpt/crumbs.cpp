#include "core/sculpt/crumbs.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace sculpt {

using base::Vec3f;

/// A sheet has at least so many surfels.
constexpr std::size_t enough = 6;
/// Neighbours on a sheet: in spacings at most, and the least cosine between their normals.
constexpr float reach = 2.2f, facing = -0.2f;
/// Nearest surfels asked, so that the other side of something thin may be among them.
constexpr std::size_t asked = 16;
/// A surface needs some surfels to be one.
constexpr std::size_t fewest = 16;

/// Are there enough neighbours in the surfel's own cluster? Of most it says at once that they are no crumbs.
static bool borneByItsCluster(const surfel::SurfelBlock& block, int slot, float link) {
    const Vec3f p = block.position(slot), n = block.normal(slot);
    const int begin = slot / surfel::clusterSize * surfel::clusterSize;
    std::size_t count = 0;
    for (int k = begin; k < std::min(begin + surfel::clusterSize, block.size()); ++k) {
        const Vec3f other = block.normal(k);
        const bool alike = n == Vec3f{} || other == Vec3f{} || dot(n, other) > facing;
        count += alike && distanceSq(block.position(k), p) < link * link ? 1 : 0;
    }
    return count >= enough;
}

/// How many surfels the sheet around x has, counted up to `enough`.
static std::size_t sheetAround(const tree::SurfelTree& tree, const Vec3f& x, const Vec3f& normal, float link) {
    struct Member {
        Vec3f position, normal;
        const surfel::SurfelBlock* block;
        int slot;
    };
    std::vector<Member> members;
    std::vector<tree::Neighbour> near;
    const auto takeAround = [&](const Vec3f& at, const Vec3f& n) {
        tree.nearest(at, asked, near, link);
        for (const tree::Neighbour& each : near) {
            const bool known = std::any_of(members.begin(), members.end(), [&](const Member& m) {
                return m.block == each.block && m.slot == each.slot;
            });
            const Vec3f other = each.block->normal(each.slot);
            const bool alike = n == Vec3f{} || other == Vec3f{} || dot(n, other) > facing;
            if (!known && alike)
                members.push_back({each.block->position(each.slot), other, each.block, each.slot});
        }
    };
    takeAround(x, normal);
    for (std::size_t k = 0; k < members.size() && members.size() < enough; ++k)
        takeAround(Vec3f(members[k].position), Vec3f(members[k].normal));
    return members.size();
}

/// The same around the surfel of a version that is nearest to x.
static std::size_t sheetBefore(const tree::SurfelTree& first, const Vec3f& x, float link) {
    std::vector<tree::Neighbour> near;
    first.nearest(x, 1, near);
    return near.empty() ? 0 : sheetAround(first, x, near[0].block->normal(near[0].slot), link);
}

tree::Edit dropCrumbs(const tree::SurfelTree& now, const tree::SurfelTree& first, const tree::Selection& candidates,
                      const std::function<CrumbSource(const surfel::SurfelBlock&, int slot)>& sourceOf) {
    std::vector<std::bitset<surfel::blockCapacity>> gone(candidates.size());
    base::parallelFor(candidates.size(), 1, [&](std::size_t i) {
        const surfel::BlockPtr block = now.block(candidates[i].block);
        for (int slot = 0; slot < block->size(); ++slot) {
            if (!candidates[i].slots[static_cast<std::size_t>(slot)] || block->mask(slot) >= 1)
                continue;
            const CrumbSource source = sourceOf(*block, slot);
            const float link = reach * source.spacing;
            if (borneByItsCluster(*block, slot, link))
                continue;
            gone[i].set(static_cast<std::size_t>(slot),
                        sheetAround(now, block->position(slot), block->normal(slot), link) < enough &&
                            sheetBefore(first, source.origin, link) >= enough);
        }
    });
    tree::Edit edit;
    edit.inserted.layout = now.layout();
    std::size_t count = 0;
    for (std::size_t i = 0; i < gone.size(); ++i)
        if (gone[i].any())
            count += gone[i].count(), edit.blocks.push_back({candidates[i].block, {}, gone[i]});
    return count + fewest <= now.size() ? edit : tree::Edit{};
}

} // namespace sculpt
