#include "core/tree/cutting.h"

#include <cassert>

namespace tree {

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

int longestAxis(std::span<const CutItem> items) {
    float lo[3], hi[3];
    for (int k = 0; k < 3; ++k)
        lo[k] = hi[k] = items[0].position[k];
    for (const CutItem& item : items)
        for (int k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], item.position[k]);
            hi[k] = std::max(hi[k], item.position[k]);
        }
    const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/// Puts the `middle` smallest along the longest axis in front.
void partition(std::span<CutItem> items, std::size_t middle) {
    const int axis = longestAxis(items);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                     [axis](const CutItem& a, const CutItem& b) {
                         const float p = a.position[axis], q = b.position[axis];
                         return p != q ? p < q : a.source < b.source;
                     });
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
    partition(items, middle);
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
    partition(items, middle);
    std::vector<surfel::BlockPtr> out = cutIntoBlocks(pool, items.first(middle), left, extraWords);
    for (auto& block : cutIntoBlocks(pool, items.subspan(middle), blockCount - left, extraWords))
        out.push_back(std::move(block));
    return out;
}

} // namespace tree
