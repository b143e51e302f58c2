#include "core/sculpt/tools/inside.h"

#include "core/base/parallel.h"

namespace sculpt {

tree::Selection inside(const tree::SurfelTree& tree, const Brush& brush, float radius) {
    if (!(radius > 0))
        return {};
    const std::vector<BrushBlock> blocks = blocksUnder(tree, brush.centre, brush.radius);
    tree::Selection all(blocks.size());
    base::parallelFor(blocks.size(), 8, [&](std::size_t b) {
        all[b].block = blocks[b].number;
        alignas(64) float weight[lanes];
        for (int cluster = 0; cluster < blocks[b].block->clusterCount(); ++cluster) {
            if (!brush.reaches(*blocks[b].block, cluster) || !brush.weigh(blocks[b], cluster, weight))
                continue;
            for (std::size_t i = 0; i < lanes; ++i) {
                const int slot = cluster * surfel::clusterSize + static_cast<int>(i);
                if (weight[i] > 0 && distanceSq(blocks[b].block->position(slot), brush.centre) < radius * radius)
                    all[b].slots.set(static_cast<std::size_t>(slot));
            }
        }
    });
    std::erase_if(all, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return all;
}

} // namespace sculpt
