// What is shown anew where layers changed, without a stroke.
#include "core/base/parallel.h"
#include "core/layers/settle_block.h"

#include <algorithm>
#include <cmath>

namespace layers {

using surfel::clusterSize, surfel::MutableBlockPtr, surfel::SurfelBlock;
using tree::SurfelTree;

/// Blocks on one thread in a row.
constexpr std::size_t grain = 16;

bool takesStrokes(const Stack& stack) {
    const int target = stack.target();
    return target < 0 || std::abs(stack.layers[static_cast<std::size_t>(target)].weight()) >= leastRecording;
}

namespace {

/// Does any of these layers displace something in a block?
bool touches(const SurfelBlock& block, const std::vector<int>& channels) {
    for (const int first : channels)
        for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
            const float* words = block.channel(cluster, first);
            float any = 0;
            for (int i = 0; i < OwnMask * clusterSize; ++i)
                any += std::abs(words[i]);
            if (any != 0)
                return true;
        }
    return false;
}

/// The layers that count otherwise than before: other weights, or another place among the rest.
std::vector<int> changedChannels(const Channels& channels, const Stack& from, const Stack& to) {
    std::vector<int> out;
    for (std::size_t i = 0; i < to.layers.size(); ++i) {
        const int was = from.indexOf(to.layers[i].id);
        if (was != static_cast<int>(i) || from.layers[i].weight() != to.layers[i].weight())
            out.push_back(channels.layers[i]);
    }
    return out;
}

/// The version in which `change` was done to copies of the blocks that `concerns`, in parallel.
template <class Concerns, class Change>
Restacked rewritten(const SurfelTree& tree, const Concerns& concerns, const Change& change) {
    std::vector<const SurfelBlock*> blocks(tree.blockCount());
    tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) { blocks[number] = &block; });
    std::vector<MutableBlockPtr> next(blocks.size());
    base::parallelFor(blocks.size(), grain, [&](std::size_t b) {
        if (!concerns(*blocks[b]))
            return;
        next[b] = blocks[b]->clone();
        change(*next[b]);
        next[b]->seal();
    });
    Restacked out;
    tree::Edit edit;
    for (std::size_t b = 0; b < next.size(); ++b)
        if (next[b]) {
            out.changed.push_back(blocks[b]->box());
            out.changed.push_back(next[b]->box());
            edit.blocks.push_back({static_cast<std::uint32_t>(b), next[b], {}});
        }
    out.tree = tree.apply(edit);
    return out;
}

int lanesOf(const SurfelBlock& block, int cluster) {
    return std::min(clusterSize, block.size() - cluster * clusterSize);
}

/// All surfels where their words show them.
void showAll(SurfelBlock& block, const Channels& channels, std::span<const float> weights) {
    ShownCluster shown;
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
        show(block, cluster, channels, weights, shown);
        for (int lane = 0; lane < lanesOf(block, cluster); ++lane)
            shown.put(block, cluster, lane);
    }
}

} // namespace

Restacked restacked(const SurfelTree& tree, const Stack& from, const Stack& to) {
    const auto channels = Channels::of(*tree.layout(), to);
    if (!channels)
        return {tree, {}};
    const std::vector<int> changed = changedChannels(*channels, from, to);
    const std::vector<float> weights = weightsOf(to);
    return rewritten(
        tree, [&](const SurfelBlock& block) { return touches(block, changed); },
        [&](SurfelBlock& block) { showAll(block, *channels, weights); });
}

/// What a layer holds in a cluster times 1 - mask, and no mask.
static void bakeMask(float* layer) {
    for (int word = 0; word < OwnMask; ++word)
        for (int i = 0; i < clusterSize; ++i)
            layer[word * clusterSize + i] *= 1 - layer[OwnMask * clusterSize + i];
    std::fill_n(layer + OwnMask * clusterSize, clusterSize, 0.0f);
}

SurfelTree merged(const SurfelTree& tree, const Stack& stack, int index) {
    const auto channels = Channels::of(*tree.layout(), stack);
    if (!channels)
        return tree;
    const auto at = static_cast<std::size_t>(index);
    const SettleRules rules{*channels, weightsOf(stack), index - 1, How::Record};
    return rewritten(
               tree, [&](const SurfelBlock& block) { return touches(block, {channels->layers[at]}); },
               [&](SurfelBlock& block) {
                   for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
                       if (index > 0)
                           bakeMask(block.channel(cluster, channels->layers[at - 1]));
                       std::fill_n(block.channel(cluster, channels->layers[at]), layerWords * clusterSize, 0.0f);
                   }
                   settle(block, rules, nullptr);
               })
        .tree;
}

Restacked masked(const SurfelTree& tree, const Stack& stack, int index,
                 const std::function<float(const SurfelBlock&, int slot)>& hides) {
    const auto channels = Channels::of(*tree.layout(), stack);
    if (!channels)
        return {tree, {}};
    const int mask = channels->layers[static_cast<std::size_t>(index)] + OwnMask;
    const std::vector<float> weights = weightsOf(stack);
    const auto old = [&](const SurfelBlock& block, int slot) {
        return block.channel(slot / clusterSize, mask)[slot % clusterSize];
    };
    return rewritten(
        tree,
        [&](const SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (hides(block, slot) != old(block, slot))
                    return true;
            return false;
        },
        [&](SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                block.channel(slot / clusterSize, mask)[slot % clusterSize] = hides(block, slot);
            showAll(block, *channels, weights);
        });
}

SurfelTree mapped(const SurfelTree& after, const Stack& stack, const base::Mat3d& linear, const base::Vec3d& shift) {
    const auto channels = Channels::of(*after.layout(), stack);
    if (stack.empty() || !channels)
        return after;
    const base::Mat3d area = base::cofactor(linear);
    const double side = base::determinant(linear) < 0 ? -1 : 1;
    const SettleRules rules{*channels, weightsOf(stack), -1, How::Keep};
    return rewritten(
               after, [](const SurfelBlock&) { return true; },
               [&](SurfelBlock& block) {
                   SurfelLayers words;
                   for (int slot = 0; slot < block.size(); ++slot) {
                       words.read(block, slot, *channels);
                       const base::Vec3d normal = area * words.normal;
                       const double stretch = length(normal) > 0 ? length(normal) : 1.0;
                       words.base = linear * words.base + shift;
                       words.normal = normal * (side / stretch);
                       words.support *= std::sqrt(stretch); // which says how far layers lean
                       for (SurfelLayers::Part& part : words.parts)
                           part.d = linear * part.d, part.e = area * part.e * (side / stretch);
                       words.write(block, slot, *channels);
                   }
                   settle(block, rules, nullptr);
               })
        .tree;
}

} // namespace layers
