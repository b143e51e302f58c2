#include "core/sculpt/crumbs.h"

#include "core/base/parallel.h"
#include "core/sculpt/fold_strays.h"
#include "core/tree/nearest_together.h"

#include <algorithm>

namespace sculpt {

using base::Vec3f;

/// A sheet has at least so many surfels.
constexpr std::size_t enough = 6;
/// Neighbours on a sheet: in spacings at most, and the least cosine between their normals.
constexpr float reach = 2.2f, facing = -0.2f;
/// Nearest surfels asked at first, so that the other side of something thin may be among them.
constexpr std::size_t nearest = 16;
/// A surface needs some surfels to be one.
constexpr std::size_t fewest = 16;

static bool alike(const Vec3f& a, const Vec3f& b) {
    return a == Vec3f{} || b == Vec3f{} || dot(a, b) > facing;
}

/// Are there enough neighbours in the surfel's own cluster? Of most it says at once that they are no crumbs.
static bool borneByItsCluster(const surfel::SurfelBlock& block, int slot, float link) {
    const Vec3f p = block.position(slot), n = block.normal(slot);
    const int begin = slot / surfel::clusterSize * surfel::clusterSize;
    std::size_t count = 0;
    for (int k = begin; k < std::min(begin + surfel::clusterSize, block.size()); ++k)
        count += alike(n, block.normal(k)) && distanceSq(block.position(k), p) < link * link ? 1 : 0;
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
    // All within reach: of the nearest few all may be of the other side of something thin, where that is finer.
    const auto takeAround = [&](const Vec3f& at, const Vec3f& n) {
        tree.forBlocksInBall(at, link, [&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size() && members.size() < enough; ++slot) {
                const Vec3f place = block.position(slot), other = block.normal(slot);
                if (distanceSq(place, at) >= link * link || !alike(n, other))
                    continue;
                const bool known = std::any_of(members.begin(), members.end(),
                                               [&](const Member& m) { return m.block == &block && m.slot == slot; });
                if (!known)
                    members.push_back({place, other, &block, slot});
            }
        });
    };
    takeAround(x, normal);
    for (std::size_t k = 0; k < members.size() && members.size() < enough; ++k)
        takeAround(Vec3f(members[k].position), Vec3f(members[k].normal));
    return members.size();
}

/// Of these slots those around which too few of a sheet are linked directly, for whom it has to be followed. `link`: of
/// each.
static std::vector<int> littleAround(tree::NearestTogether& around, const surfel::SurfelBlock& block,
                                     std::span<const int> slots, std::span<const float> link) {
    std::vector<Vec3f> places;
    for (const int slot : slots)
        places.push_back(block.position(slot));
    std::vector<int> out;
    around.forEach(places, [&](std::size_t i, std::span<const tree::Neighbour> near) {
        const auto linked = std::count_if(near.begin(), near.end(), [&](const tree::Neighbour& each) {
            return each.distanceSq < link[i] * link[i] && alike(block.normal(slots[i]), each.block->normal(each.slot));
        });
        if (static_cast<std::size_t>(linked) < enough)
            out.push_back(slots[i]);
    });
    return out;
}

/// The same around the surfel of a version that is nearest to x.
static std::size_t sheetBefore(const tree::SurfelTree& first, const Vec3f& x, float link) {
    std::vector<tree::Neighbour> near;
    first.nearest(x, 1, near);
    return near.empty() ? 0 : sheetAround(first, x, near[0].block->normal(near[0].slot), link);
}

tree::Edit dropCrumbs(const tree::SurfelTree& now, const tree::SurfelTree& first, const tree::Selection& candidates,
                      const SourceOf& sourceOf) {
    const FoldStrays strays(now, first);
    std::vector<std::bitset<surfel::blockCapacity>> gone(candidates.size());
    base::parallelFor(candidates.size(), 1, [&](std::size_t i) {
        const surfel::BlockPtr block = now.block(candidates[i].block);
        gone[i] = strays.in(*block, candidates[i].slots, sourceOf);
        std::vector<int> asked;
        std::vector<float> link;
        for (int slot = 0; slot < block->size(); ++slot) {
            if (!candidates[i].slots[static_cast<std::size_t>(slot)] || block->mask(slot) >= 1)
                continue;
            const float far = reach * sourceOf(*block, slot).spacing;
            if (!borneByItsCluster(*block, slot, far))
                asked.push_back(slot), link.push_back(far);
        }
        if (asked.empty())
            return;
        tree::NearestTogether around(now, nearest);
        for (const int slot : littleAround(around, *block, asked, link)) {
            const CrumbSource source = sourceOf(*block, slot);
            const float far = reach * source.spacing;
            if (sheetAround(now, block->position(slot), block->normal(slot), far) < enough &&
                sheetBefore(first, source.origin, far) >= enough)
                gone[i].set(static_cast<std::size_t>(slot));
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
