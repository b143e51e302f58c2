#include "core/selection/field.h"

#include "core/base/error.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace selection {

using surfel::BlockPtr, surfel::clusterSize, surfel::SurfelBlock;
using tree::SurfelTree;

/// Blocks on one thread in a row.
constexpr std::size_t copied = 16;

[[noreturn]] static void refuseName(Field field) {
    const std::string name = attributeName(field);
    throw base::Error("the model has an attribute \"" + name + "\" that is no float, where what is " +
                          (field == Field::Hidden ? "hidden" : "selected") + " is kept",
                      {}, "give it another name in the file");
}

int channelOf(const surfel::AttributeLayout& layout, Field field) {
    if (field == Field::Mask)
        return surfel::Mask;
    const surfel::Attribute* attribute = layout.find(attributeName(field));
    if (attribute && attribute->type != surfel::ScalarType::Float32) {
        if (field == Field::Selection)
            refuseName(field);
        return -1;
    }
    return attribute ? surfel::Extra + static_cast<int>(attribute->firstWord) : -1;
}

void read(const SurfelBlock& block, int channel, BlockValues& out) {
    out.fill(0);
    for (int cluster = 0; channel >= 0 && cluster < block.clusterCount(); ++cluster)
        std::copy_n(block.channel(cluster, channel), std::min(clusterSize, block.size() - cluster * clusterSize),
                    out.begin() + cluster * clusterSize);
}

std::vector<const SurfelBlock*> blocksOf(const SurfelTree& tree) {
    std::vector<const SurfelBlock*> out(tree.blockCount());
    tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) { out[number] = &block; });
    return out;
}

static void write(SurfelBlock& block, int channel, const BlockValues& values) {
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster)
        std::copy_n(values.begin() + cluster * clusterSize, std::min(clusterSize, block.size() - cluster * clusterSize),
                    block.channel(cluster, channel));
}

/// The same surfels with one more word each, behind those that they have.
static BlockPtr widened(const SurfelBlock& block, const BlockValues& values) {
    surfel::MutableBlockPtr out = SurfelBlock::create(block.size(), block.extraWords() + 1);
    const int channels = surfel::Extra + static_cast<int>(block.extraWords());
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster)
        std::copy_n(block.channel(cluster, 0), channels * clusterSize, out->channel(cluster, 0));
    write(*out, channels, values);
    out->seal();
    return out;
}

/// A version of all blocks: those without a new content keep theirs, with zeros in the new word.
static SurfelTree widenedTree(const SurfelTree& tree, const std::vector<const SurfelBlock*>& blocks,
                              std::span<const std::uint32_t> numbers, const std::vector<BlockValues>& values,
                              Field field) {
    tree::Edit edit;
    edit.blocks.resize(blocks.size());
    std::vector<const BlockValues*> of(blocks.size(), nullptr);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        of[numbers[i]] = &values[i];
    base::parallelFor(blocks.size(), copied, [&](std::size_t b) {
        edit.blocks[b].block = static_cast<std::uint32_t>(b);
        edit.blocks[b].changed = widened(*blocks[b], of[b] ? *of[b] : BlockValues{});
    });
    auto layout = std::make_shared<surfel::AttributeLayout>(*tree.layout());
    if (layout->find(attributeName(field)))
        refuseName(field);
    layout->add(attributeName(field), surfel::ScalarType::Float32);
    edit.layout = layout;
    return tree.apply(edit);
}

/// What is selected or hidden for the first time: nothing is made anew where that is nothing.
static SurfelTree firstSelected(const SurfelTree& tree, Field field, std::span<const std::uint32_t> numbers,
                                const Rewrite& rewrite, std::size_t grain) {
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<BlockValues> values(numbers.size());
    base::parallelFor(numbers.size(), grain, [&](std::size_t i) {
        values[i].fill(0);
        rewrite(numbers[i], *blocks[numbers[i]], values[i]);
    });
    const bool any = std::any_of(values.begin(), values.end(), [](const BlockValues& each) {
        return std::any_of(each.begin(), each.end(), [](float v) { return v != 0; });
    });
    return any ? widenedTree(tree, blocks, numbers, values, field) : tree;
}

SurfelTree rewritten(const SurfelTree& tree, Field field, std::span<const std::uint32_t> numbers,
                     const Rewrite& rewrite, std::size_t grain) {
    const int channel = channelOf(*tree.layout(), field);
    if (channel < 0)
        return firstSelected(tree, field, numbers, rewrite, grain);
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<BlockPtr> changed(numbers.size());
    base::parallelFor(numbers.size(), grain, [&](std::size_t i) {
        const SurfelBlock& block = *blocks[numbers[i]];
        BlockValues old, next;
        read(block, channel, old);
        next = old;
        rewrite(numbers[i], block, next);
        std::fill(next.begin() + block.size(), next.end(), 0.0f);
        if (next == old)
            return;
        surfel::MutableBlockPtr copy = block.clone(); // its bounds do not depend on fields
        write(*copy, channel, next);
        changed[i] = copy;
    });
    tree::Edit edit;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (changed[i])
            edit.blocks.push_back({numbers[i], std::move(changed[i]), {}});
    if (field == Field::Mask && !edit.blocks.empty() && !tree.layout()->masks) {
        auto layout = std::make_shared<surfel::AttributeLayout>(*tree.layout());
        layout->masks = true;
        edit.layout = layout;
    }
    return tree.apply(edit);
}

SurfelTree rewritten(const SurfelTree& tree, Field field, const Rewrite& rewrite, std::size_t grain) {
    std::vector<std::uint32_t> all(tree.blockCount());
    std::iota(all.begin(), all.end(), 0u);
    return rewritten(tree, field, all, rewrite, grain);
}

tree::Selection selectedIn(const SurfelTree& tree, Field field) {
    const int channel = channelOf(*tree.layout(), field);
    tree::Selection out;
    if (channel < 0)
        return out;
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    tree::Selection all(blocks.size());
    base::parallelFor(blocks.size(), copied, [&](std::size_t b) {
        all[b].block = static_cast<std::uint32_t>(b);
        for (int slot = 0; slot < blocks[b]->size(); ++slot)
            all[b].slots[static_cast<std::size_t>(slot)] = valueAt(*blocks[b], channel, slot) >= half;
    });
    std::copy_if(all.begin(), all.end(), std::back_inserter(out),
                 [](const tree::SelectedBlock& block) { return block.slots.any(); });
    return out;
}

SurfelTree combined(const SurfelTree& tree, const tree::Selection& found, Mode mode) {
    std::vector<const std::bitset<surfel::blockCapacity>*> of(tree.blockCount(), nullptr);
    std::vector<std::uint32_t> numbers;
    for (const tree::SelectedBlock& each : found) {
        of[each.block] = &each.slots;
        numbers.push_back(each.block);
    }
    const auto join = [&](std::uint32_t number, const SurfelBlock& block, BlockValues& values) {
        const auto* slots = of[number];
        for (std::size_t i = 0; i < static_cast<std::size_t>(block.size()); ++i) {
            const bool in = slots && (*slots)[i];
            switch (mode) {
            case Mode::Replace:
                values[i] = in ? 1.0f : 0.0f;
                break;
            case Mode::Add:
                values[i] = in ? 1.0f : values[i];
                break;
            case Mode::Subtract:
                values[i] = in ? 0.0f : values[i];
                break;
            case Mode::Intersect:
                values[i] = in ? values[i] : 0.0f;
                break;
            }
        }
    };
    const bool everywhere =
        (mode == Mode::Replace && channelOf(*tree.layout(), Field::Selection) >= 0) || mode == Mode::Intersect;
    return everywhere ? rewritten(tree, Field::Selection, join) : rewritten(tree, Field::Selection, numbers, join);
}

} // namespace selection
