#include "core/sculpt/tools/gather.h"

namespace sculpt {

Gathered gather(const std::vector<BrushBlock>& blocks, const Brush& brush) {
    Gathered out;
    alignas(64) float weight[lanes];
    for (const BrushBlock& in : blocks) {
        out.first.push_back(out.places.size());
        for (int cluster = 0; cluster < in.block->clusterCount(); ++cluster) {
            if (!brush.reaches(*in.block, cluster) || !brush.weigh(in, cluster, weight, false))
                continue;
            for (int lane = 0; lane < surfel::clusterSize; ++lane) {
                const int slot = cluster * surfel::clusterSize + lane;
                if (weight[lane] == 0 || in.block->mask(slot) >= 1)
                    continue;
                out.places.push_back(in.block->position(slot));
                out.weight.push_back(weight[lane]);
                out.free.push_back(1 - in.block->mask(slot));
                out.slots.push_back(slot);
            }
        }
    }
    out.first.push_back(out.places.size());
    return out;
}

} // namespace sculpt
