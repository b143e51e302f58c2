#include "core/tree/cutting.h"

#include <bit>
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

/// The words of a slot, one in each channel.
std::uint32_t* wordsOf(SurfelBlock& block, int slot) {
    return block.words(slot / clusterSize, 0) + slot % clusterSize;
}

void copyListed(const surfel::SurfelList& list, std::size_t index, SurfelBlock& block, int slot) {
    const surfel::Surfel& s = list.items[index];
    const std::uint32_t words[surfel::Extra] = {
        std::bit_cast<std::uint32_t>(s.position.x), std::bit_cast<std::uint32_t>(s.position.y),
        std::bit_cast<std::uint32_t>(s.position.z), std::bit_cast<std::uint32_t>(s.normal.x),
        std::bit_cast<std::uint32_t>(s.normal.y),   std::bit_cast<std::uint32_t>(s.normal.z),
        std::bit_cast<std::uint32_t>(s.support),    s.colour,
        std::bit_cast<std::uint32_t>(s.mask)};
    std::uint32_t* const out = wordsOf(block, slot);
    for (std::size_t c = 0; c < surfel::Extra; ++c)
        out[c * clusterSize] = words[c];
    if (block.extraWords() > 0)
        block.setExtra(slot, list.extraOf(index));
}

void copySlot(const SurfelBlock& from, int fromSlot, SurfelBlock& block, int slot) {
    const std::uint32_t* in = from.words(fromSlot / clusterSize, 0) + fromSlot % clusterSize;
    std::uint32_t* out = wordsOf(block, slot);
    const std::size_t channels = surfel::Extra + block.extraWords();
    for (std::size_t c = 0; c < channels; ++c)
        out[c * clusterSize] = in[c * clusterSize];
}

/// Lists are in no order: what comes next is asked for while the present one is copied.
void askFor(const Pool& pool, std::uint32_t source) {
    if (source < Pool::listBase)
        return;
    const auto* const surfel = reinterpret_cast<const char*>(&pool.list->items[source - Pool::listBase]);
    __builtin_prefetch(surfel);
    __builtin_prefetch(surfel + sizeof(surfel::Surfel) - 1);
}

surfel::BlockPtr makeBlock(const Pool& pool, std::span<const std::uint32_t> sources, std::size_t extraWords) {
    constexpr std::size_t ahead = 16;
    const surfel::MutableBlockPtr block = SurfelBlock::create(static_cast<int>(sources.size()), extraWords);
    for (std::size_t k = 0; k < sources.size(); ++k) {
        if (k + ahead < sources.size())
            askFor(pool, sources[k + ahead]);
        const std::uint32_t source = sources[k];
        const int slot = static_cast<int>(k);
        if (source >= Pool::listBase)
            copyListed(*pool.list, source - Pool::listBase, *block, slot);
        else
            copySlot(*pool.blocks[source / surfel::blockCapacity], static_cast<int>(source % surfel::blockCapacity),
                     *block, slot);
    }
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
