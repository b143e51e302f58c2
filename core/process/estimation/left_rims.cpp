#include "core/process/estimation/left_rims.h"

#include "core/base/cancel_scope.h"
#include "core/surface/rims.h"
#include "core/surfel/widen.h"
#include "core/tree/with_surfels.h"

#include <map>

namespace process {

using surfel::SurfelBlock;

namespace {

tree::SurfelTree treeOf(std::span<const base::Vec3f> places) {
    surfel::SurfelList list;
    for (const base::Vec3f& place : places)
        list.items.push_back({place, {}, 1});
    return tree::SurfelTree::build(list);
}

/// The block with marks; null where it has them all.
surfel::BlockPtr marked(const SurfelBlock& block, int channel, const tree::SurfelTree& gone) {
    surfel::MutableBlockPtr out;
    std::vector<tree::Neighbour> nearest;
    for (int slot = 0; slot < block.size(); ++slot) {
        const int cluster = slot / surfel::clusterSize, lane = slot % surfel::clusterSize;
        if (block.words(cluster, channel)[lane] != 0)
            continue;
        gone.nearest(block.position(slot), 1, nearest, reachOfLeftRims * block.support(slot));
        if (nearest.empty())
            continue;
        if (!out)
            out = block.clone();
        out->words(cluster, channel)[lane] = 1;
    }
    if (out)
        out->seal();
    return out;
}

} // namespace

tree::Edit rimsBeside(const surface::Surface& left, std::span<const base::Vec3f> gone) {
    tree::Edit edit;
    edit.inserted.layout = left.tree().layout();
    if (gone.empty())
        return edit;
    const int channel = *surface::rimChannel(*left.tree().layout());
    const tree::SurfelTree holes = treeOf(gone);
    left.tree().forBlocksInSupport(
        holes.bounds(),
        [&](std::uint32_t number, const SurfelBlock& block) {
            base::CancelScope::check();
            if (surfel::BlockPtr changed = marked(block, channel, holes))
                edit.blocks.push_back({number, std::move(changed), {}});
        },
        reachOfLeftRims);
    return edit;
}

tree::SurfelTree withRimAttribute(const tree::SurfelTree& tree) {
    if (tree.layout()->find(surface::rimName))
        return tree;
    surfel::SurfelList list = tree.surfels();
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->add(surface::rimName, surfel::ScalarType::UInt8);
    surfel::widen(list, std::move(layout));
    return tree::withSurfels(tree, list);
}

void addRims(const surface::Surface& version, tree::Edit& edit) {
    if (!surface::knowsRims(version))
        return;
    std::vector<base::Vec3f> gone;
    std::map<std::uint32_t, tree::BlockEdit> blocks;
    for (tree::BlockEdit& each : edit.blocks) {
        for (std::size_t slot = 0; slot < each.removed.size(); ++slot)
            if (each.removed[slot])
                gone.push_back(version.tree().block(each.block)->position(static_cast<int>(slot)));
        blocks.emplace(each.block, std::move(each));
    }
    for (tree::BlockEdit& each : rimsBeside(version, gone).blocks)
        blocks[each.block] = {each.block, std::move(each.changed), blocks[each.block].removed};
    edit.blocks.clear();
    for (auto& [number, each] : blocks)
        edit.blocks.push_back(std::move(each));
}

} // namespace process
