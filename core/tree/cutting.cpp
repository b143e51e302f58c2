#include "core/tree/cutting.h"

#include "core/tree/select.h"

#include <cassert>

namespace tree {

/// Cuts into at most so many blocks try all three axes; above, three times the work would not show in the queries.
constexpr std::size_t carefulBlocks = 16;

using surfel::clusterSize;
using surfel::SurfelBlock;

void Pool::addBlock(const SurfelBlock& block, const std::bitset<surfel::blockCapacity>& removed) {
    const auto base = static_cast<std::uint32_t>(blocks.size()) * surfel::blockCapacity;
    assert(base + surfel::blockCapacity <= listBase);
    blocks.push_back(&block);
    for (int slot = 0; slot < block.size(); ++slot) {
        if (removed[static_cast<std::size_t>(slot)])
            continue;
        const base::Vec3f p = block.position(slot);
        items.push_back({{p.x, p.y, p.z}, base + static_cast<std::uint32_t>(slot)});
    }
}

void Pool::addListed(std::uint32_t index) {
    const base::Vec3f& p = list->items[index].position;
    items.push_back({{p.x, p.y, p.z}, listBase + index});
}

namespace {

base::Box3f boxOf(std::span<const CutItem> items) {
    base::Box3f box;
    for (const CutItem& item : items)
        box.extend(base::Vec3f{item.position[0], item.position[1], item.position[2]});
    return box;
}

std::size_t longestAxis(const base::Box3f& box) {
    const base::Vec3f s = box.size();
    return s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
}

/// Sum of the sides: of two cuts of a thin sheet it prefers the one into compact pieces, where area is blind.
float cost(const base::Box3f& box) {
    const base::Vec3f s = box.size();
    return s.x + s.y + s.z;
}

/// Puts the `middle` smallest in front, along the axis that leaves the smaller boxes.
void partitionWell(std::span<CutItem> items, std::size_t middle) {
    std::size_t best = 0, last = 0;
    float bestCost = std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        selectSmallest(items, middle, last = axis);
        const float sum = cost(boxOf(items.first(middle))) + cost(boxOf(items.subspan(middle)));
        if (sum < bestCost)
            bestCost = sum, best = axis;
    }
    if (best != last)
        selectSmallest(items, middle, best);
}

std::size_t clustersFor(std::size_t count) {
    return (count + clusterSize - 1) / clusterSize;
}

void arrangeClusters(std::span<CutItem> items) {
    if (items.size() <= clusterSize) {
        std::sort(items.begin(), items.end(), [](const CutItem& a, const CutItem& b) { return a.source < b.source; });
        return;
    }
    const std::size_t middle = clustersFor(items.size()) / 2 * clusterSize;
    selectSmallest(items, middle, longestAxis(boxOf(items)));
    arrangeClusters(items.first(middle));
    arrangeClusters(items.subspan(middle));
}

void copySurfel(const Pool& pool, std::uint32_t source, SurfelBlock& block, int slot) {
    if (source >= Pool::listBase) {
        const std::size_t index = source - Pool::listBase;
        block.set(slot, pool.list->items[index]);
        block.setExtra(slot, pool.list->extraOf(index));
        return;
    }
    const SurfelBlock& from = *pool.blocks[source / surfel::blockCapacity];
    const int fromSlot = static_cast<int>(source % surfel::blockCapacity);
    const std::uint32_t* in = from.words(fromSlot / clusterSize, 0) + fromSlot % clusterSize;
    std::uint32_t* out = block.words(slot / clusterSize, 0) + slot % clusterSize;
    const std::size_t channels = surfel::Extra + block.extraWords();
    for (std::size_t c = 0; c < channels; ++c)
        out[c * clusterSize] = in[c * clusterSize];
}

surfel::BlockPtr makeBlock(const Pool& pool, std::span<const CutItem> items, std::size_t extraWords) {
    const surfel::MutableBlockPtr block = SurfelBlock::create(static_cast<int>(items.size()), extraWords);
    for (std::size_t slot = 0; slot < items.size(); ++slot)
        copySurfel(pool, items[slot].source, *block, static_cast<int>(slot));
    block->seal();
    return block;
}

} // namespace

std::vector<surfel::BlockPtr> cutIntoBlocks(const Pool& pool, std::span<CutItem> items, std::size_t blockCount,
                                            std::size_t extraWords) {
    if (blockCount == 1) {
        assert(items.size() <= surfel::blockCapacity);
        arrangeClusters(items);
        return {makeBlock(pool, items, extraWords)};
    }
    const std::size_t left = blockCount / 2;
    const std::size_t middle = (clustersFor(items.size()) * left + blockCount / 2) / blockCount * clusterSize;
    if (blockCount <= carefulBlocks)
        partitionWell(items, middle);
    else
        selectSmallest(items, middle, longestAxis(boxOf(items)));
    std::vector<surfel::BlockPtr> out = cutIntoBlocks(pool, items.first(middle), left, extraWords);
    for (auto& block : cutIntoBlocks(pool, items.subspan(middle), blockCount - left, extraWords))
        out.push_back(std::move(block));
    return out;
}

} // namespace tree
