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

surfel::BlockPtr makeBlock(const Pool& pool, std::span<const std::uint32_t> sources, std::size_t extraWords) {
    const surfel::MutableBlockPtr block = SurfelBlock::create(static_cast<int>(sources.size()), extraWords);
    for (std::size_t slot = 0; slot < sources.size(); ++slot)
        copySurfel(pool, sources[slot], *block, static_cast<int>(slot));
    block->seal();
    return block;
}

} // namespace

std::vector<surfel::BlockPtr> cutIntoBlocks(const Pool& pool, CutLanes& places, std::size_t blockCount,
                                            std::size_t extraWords) {
    std::vector<surfel::BlockPtr> out;
    const std::uint32_t* next = places.sources();
    for (const std::uint32_t size : places.cut(blockCount)) {
        assert(size <= surfel::blockCapacity);
        out.push_back(makeBlock(pool, {next, size}, extraWords));
        next += size;
    }
    return out;
}

std::vector<surfel::BlockPtr> cutIntoBlocks(const Pool& pool, std::span<const CutItem> items, std::size_t blockCount,
                                            std::size_t extraWords) {
    CutLanes places(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            places.axis(k)[i] = items[i].position[k];
        places.sources()[i] = items[i].source;
    }
    return cutIntoBlocks(pool, places, blockCount, extraWords);
}

} // namespace tree
