#include "core/tree/tree_shape.h"

#include "core/base/parallel.h"
#include "core/tree/grouping.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <numeric>

namespace tree {

namespace {

using Sizes = std::span<const std::uint8_t>;
constexpr std::size_t blocksPerTask = 16;

std::size_t sumOf(Sizes sizes) {
    return std::accumulate(sizes.begin(), sizes.end(), std::size_t(0));
}

base::Hash128 checkOf(const std::vector<surfel::BlockPtr>& blocks) {
    constexpr std::size_t each = 5;
    std::vector<std::uint32_t> words(each * blocks.size());
    base::parallelFor(blocks.size(), blocksPerTask, [&](std::size_t b) {
        const base::Hash128 hash = blocks[b]->contentHash();
        std::uint32_t* const out = words.data() + each * b;
        out[0] = static_cast<std::uint32_t>(blocks[b]->size());
        out[1] = static_cast<std::uint32_t>(hash.lo), out[2] = static_cast<std::uint32_t>(hash.lo >> 32);
        out[3] = static_cast<std::uint32_t>(hash.hi), out[4] = static_cast<std::uint32_t>(hash.hi >> 32);
    });
    return base::hashWords(words);
}

std::vector<std::uint8_t> childCounts(const Node& root) {
    std::vector<std::uint8_t> out;
    for (std::vector<const Node*> level{&root}, below; !level.empty(); level.swap(below)) {
        below.clear();
        for (const Node* node : level) {
            out.push_back(node->childCount);
            for (std::size_t i = 0; node->level > 1 && i < node->childCount; ++i)
                below.push_back(node->nodes[i].get());
        }
    }
    return out;
}

/// How many nodes each level has, from the root down; empty where the numbers make no tree above so many blocks.
std::vector<std::size_t> levelsOf(Sizes nodes, std::size_t blocks) {
    std::vector<std::size_t> out;
    const int fewest = nodes.size() == 1 ? 1 : 2;
    std::size_t count = 1;
    for (std::size_t begin = 0; begin < nodes.size(); begin += out.back()) {
        if (count > nodes.size() - begin)
            return {};
        const Sizes level = nodes.subspan(begin, count);
        if (std::any_of(level.begin(), level.end(), [&](int n) { return n < fewest || n > fanOut; }))
            return {};
        out.push_back(count);
        count = sumOf(level);
    }
    return count == blocks ? out : std::vector<std::size_t>();
}

bool areBlocks(Sizes sizes, std::size_t surfels) {
    return std::all_of(sizes.begin(), sizes.end(), [](int n) { return n >= 1 && n <= surfel::blockCapacity; }) &&
           sumOf(sizes) == surfels;
}

std::vector<surfel::BlockPtr> blocksLike(const surfel::SurfelList& surfels, Sizes sizes) {
    std::vector<std::size_t> first(sizes.size());
    std::exclusive_scan(sizes.begin(), sizes.end(), first.begin(), std::size_t(0));
    std::vector<surfel::BlockPtr> out(sizes.size());
    base::parallelFor(sizes.size(), blocksPerTask, [&](std::size_t b) {
        const surfel::MutableBlockPtr block = surfel::SurfelBlock::create(sizes[b], surfels.layout->words());
        for (int slot = 0; slot < block->size(); ++slot) {
            const std::size_t i = first[b] + static_cast<std::size_t>(slot);
            requireValid(surfels.items[i], i);
            block->set(slot, surfels.items[i]);
            block->setExtra(slot, surfels.extraOf(i));
        }
        block->seal();
        out[b] = block;
    });
    return out;
}

NodePtr nodesAbove(const std::vector<surfel::BlockPtr>& blocks, Sizes nodes, const std::vector<std::size_t>& levels) {
    Children below;
    for (const surfel::BlockPtr& block : blocks)
        below.push_back(asChild(block));
    std::size_t end = nodes.size();
    int level = 1;
    for (auto count = levels.rbegin(); count != levels.rend(); end -= *count++, ++level) {
        Children above;
        std::span<const Child> rest(below);
        for (const std::uint8_t children : nodes.subspan(end - *count, *count)) {
            above.push_back(asChild(makeNode(level, rest.first(children))));
            rest = rest.subspan(children);
        }
        below = std::move(above);
    }
    return below.front().node;
}

} // namespace

TreeShape SurfelTree::shape() const {
    TreeShape out;
    if (!m_root)
        return out;
    std::vector<surfel::BlockPtr> blocks;
    forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        blocks.emplace_back(&block);
        out.blocks.push_back(static_cast<std::uint8_t>(block.size()));
    });
    out.nodes = childCounts(*m_root);
    out.check = checkOf(blocks);
    return out;
}

SurfelTree SurfelTree::build(const surfel::SurfelList& surfels, const TreeShape& shape,
                             const base::Progress& progress) {
    const std::vector<std::size_t> levels = levelsOf(shape.nodes, shape.blocks.size());
    if (levels.empty() || !areBlocks(shape.blocks, surfels.size()))
        return build(surfels, progress);
    progress.step(0, "indexing");
    const std::vector<surfel::BlockPtr> blocks = blocksLike(surfels, shape.blocks);
    if (!(checkOf(blocks) == shape.check))
        return build(surfels, progress);
    SurfelTree tree(nodesAbove(blocks, shape.nodes, levels), surfels.layout);
    progress.step(1, "indexing");
    return tree;
}

} // namespace tree
