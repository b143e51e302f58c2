#include "core/tree/surfel_tree.h"

#include "core/base/parallel.h"

#include <cassert>

namespace tree {

constexpr std::size_t blocksPerTask = 64;

SurfelTree SurfelTree::withLayout(surfel::AttributeLayoutPtr layout) const {
    assert(layout->words() == m_layout->words());
    return {m_root, std::move(layout)};
}

base::Box3f SurfelTree::bounds() const {
    base::Box3f box;
    for (int i = 0; m_root && i < m_root->childCount; ++i)
        box.extend(m_root->box(i));
    return box;
}

float SurfelTree::maxSupport() const {
    return m_root ? *std::max_element(std::begin(m_root->maxSupport), std::end(m_root->maxSupport)) : 0.0f;
}

surfel::BlockPtr SurfelTree::block(std::uint32_t number) const {
    assert(number < blockCount());
    const Node* node = m_root.get();
    for (;;) {
        std::size_t i = node->childCount - 1u;
        while (node->firstBlock[i] > number)
            --i;
        if (node->level == 1)
            return node->blocks[i];
        number -= node->firstBlock[i];
        node = node->nodes[i].get();
    }
}

static std::vector<const surfel::SurfelBlock*> allBlocks(const SurfelTree& tree) {
    std::vector<const surfel::SurfelBlock*> out;
    out.reserve(tree.blockCount());
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(&block); });
    return out;
}

std::vector<std::size_t> SurfelTree::firstSurfels() const {
    std::vector<std::size_t> out{0};
    out.reserve(blockCount() + 1);
    forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        out.push_back(out.back() + static_cast<std::size_t>(block.size()));
    });
    return out;
}

surfel::SurfelList SurfelTree::surfels() const {
    const auto blocks = allBlocks(*this);
    const std::vector<std::size_t> first = firstSurfels();
    const std::size_t words = m_layout->words();
    surfel::SurfelList out;
    out.layout = m_layout;
    out.items.resize(size());
    out.extra.resize(size() * words);
    base::parallelFor(blocks.size(), blocksPerTask, [&](std::size_t b) {
        for (int slot = 0; slot < blocks[b]->size(); ++slot) {
            const std::size_t i = first[b] + static_cast<std::size_t>(slot);
            out.items[i] = blocks[b]->surfel(slot);
            blocks[b]->extra(slot, {out.extra.data() + i * words, words});
        }
    });
    return out;
}

base::Hash128 SurfelTree::contentHash() const {
    const auto blocks = allBlocks(*this);
    std::vector<base::Hash128> sums(base::chunkCount(blocks.size(), blocksPerTask));
    base::parallelChunks(blocks.size(), blocksPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t b = begin; b < end; ++b)
            sums[chunk] += blocks[b]->contentHash();
    });
    base::Hash128 total;
    for (const base::Hash128& sum : sums)
        total += sum;
    return total;
}

static std::size_t bytesBelow(const Node& node) {
    std::size_t sum = sizeof(Node);
    for (std::size_t i = 0; i < node.childCount; ++i)
        sum += node.level == 1 ? node.blocks[i]->bytes() : bytesBelow(*node.nodes[i]);
    return sum;
}

std::size_t SurfelTree::bytes() const {
    return m_root ? bytesBelow(*m_root) : 0;
}

} // namespace tree
