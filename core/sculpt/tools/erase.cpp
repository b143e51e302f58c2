#include "core/sculpt/tools/erase.h"

#include "core/base/parallel.h"
#include "core/process/estimation/left_rims.h"
#include "core/sculpt/tools/brush.h"

#include <cmath>

namespace sculpt {

/// A surface needs some surfels to be one.
constexpr std::size_t fewest = 16;

static tree::Edit erase(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float least = 1 - std::abs(dab.strength);
    if (dab.strength == 0)
        return {};
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    std::vector<std::bitset<surfel::blockCapacity>> gone(blocks.size());
    base::parallelFor(blocks.size(), 8, [&](std::size_t b) {
        alignas(64) float weight[lanes];
        for (int cluster = 0; cluster < blocks[b].block->clusterCount(); ++cluster)
            if (brush.reaches(*blocks[b].block, cluster) && brush.weigh(blocks[b], cluster, weight))
                for (std::size_t i = 0; i < lanes; ++i)
                    gone[b][static_cast<std::size_t>(cluster) * lanes + i] = weight[i] > 0 && weight[i] > least;
    });
    tree::Edit edit;
    edit.inserted.layout = version.tree().layout();
    std::size_t count = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (gone[b].any())
            count += gone[b].count(), edit.blocks.push_back({blocks[b].number, {}, gone[b]});
    if (count + fewest > version.tree().size())
        return {};
    process::addRims(version, edit);
    return edit;
}

const ToolRow eraseTool{
    "erase", "Erase", "icons/tool-erase.svg", "", "Deletes surfels under the brush.", Motion::Along, 1.0,
    {},      erase,   Writes::Count};

} // namespace sculpt
