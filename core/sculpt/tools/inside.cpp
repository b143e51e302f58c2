#include "core/sculpt/tools/inside.h"

#include "core/base/parallel.h"

namespace sculpt {

static tree::SelectedBlock insideOf(const BrushBlock& in, const Brush& brush, float radius) {
    tree::SelectedBlock out{in.number, {}};
    alignas(64) float weight[lanes];
    for (int cluster = 0; cluster < in.block->clusterCount(); ++cluster) {
        if (!brush.reaches(*in.block, cluster) || !brush.weigh(in, cluster, weight))
            continue;
        for (std::size_t i = 0; i < lanes; ++i) {
            const int slot = cluster * surfel::clusterSize + static_cast<int>(i);
            if (weight[i] > 0 && distanceSq(in.block->position(slot), brush.centre) < radius * radius)
                out.slots.set(static_cast<std::size_t>(slot));
        }
    }
    return out;
}

tree::Selection inside(const tree::SurfelTree& tree, const Brush& brush, float radius) {
    if (!(radius > 0))
        return {};
    const std::vector<BrushBlock> blocks = blocksUnder(tree, brush.centre, brush.radius);
    tree::Selection all(blocks.size());
    base::parallelFor(blocks.size(), 8, [&](std::size_t b) { all[b] = insideOf(blocks[b], brush, radius); });
    std::erase_if(all, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return all;
}

tree::Selection inside(const tree::SurfelTree& tree, const Brush& brush, float radius, const tree::Selection& among) {
    tree::Selection out;
    for (const tree::SelectedBlock& each : among) {
        const surfel::BlockPtr block = tree.block(each.block);
        tree::SelectedBlock in = insideOf({each.block, block.get()}, brush, radius);
        in.slots &= each.slots;
        if (radius > 0 && in.slots.any())
            out.push_back(in);
    }
    return out;
}

} // namespace sculpt
