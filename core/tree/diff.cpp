// Differences between versions: both trees are walked down level by level together, and what both hold is dropped.
//
// A shared object stands at the same level in both trees, whatever happened above it, so that every shared node or
// block is met in both frontiers of its level unless something shared above it was dropped before. Only what is not
// shared, and the children of that, is ever looked at.
#include "core/tree/surfel_tree.h"

#include <functional>

namespace tree {

namespace {

using Nodes = std::vector<const Node*>;
using Blocks = std::vector<const surfel::SurfelBlock*>;

/// Drops from both what both contain; keeps the order of the rest.
template <class T>
void cancelShared(std::vector<const T*>& a, std::vector<const T*>& b) {
    std::vector<const T*> inA = a, inB = b;
    std::sort(inA.begin(), inA.end(), std::less<>());
    std::sort(inB.begin(), inB.end(), std::less<>());
    const auto drop = [](std::vector<const T*>& from, const std::vector<const T*>& known) {
        std::erase_if(from,
                      [&](const T* p) { return std::binary_search(known.begin(), known.end(), p, std::less<>()); });
    };
    drop(a, inB);
    drop(b, inA);
}

/// One tree's frontier: the unshared nodes of the current level.
struct Side {
    Nodes frontier;
    Blocks blocks;
    std::size_t nodeBytes = 0;

    explicit Side(const SurfelTree& tree) {
        if (tree.root())
            frontier.push_back(tree.root().get());
    }
    int level() const { return frontier.empty() ? 0 : frontier.front()->level; }
    void descend() {
        Nodes below;
        for (const Node* node : frontier)
            for (std::size_t i = 0; i < node->childCount; ++i) {
                if (node->level == 1)
                    blocks.push_back(node->blocks[i].get());
                else
                    below.push_back(node->nodes[i].get());
            }
        nodeBytes += frontier.size() * sizeof(Node);
        frontier = std::move(below);
    }
};

/// Leaves in both sides what the other does not share.
void separate(Side& a, Side& b) {
    for (int level = std::max(a.level(), b.level()); level > 0; --level) {
        if (a.level() == level && b.level() == level)
            cancelShared(a.frontier, b.frontier);
        if (a.level() == level)
            a.descend();
        if (b.level() == level)
            b.descend();
    }
    cancelShared(a.blocks, b.blocks);
}

} // namespace

Diff diff(const SurfelTree& from, const SurfelTree& to) {
    if (from == to)
        return {};
    Side a(from), b(to);
    separate(a, b);
    Diff out;
    for (const surfel::SurfelBlock* block : a.blocks)
        out.removed.emplace_back(block);
    for (const surfel::SurfelBlock* block : b.blocks)
        out.added.emplace_back(block);
    return out;
}

std::size_t unsharedBytes(const SurfelTree& version, const SurfelTree& other) {
    if (version == other)
        return 0;
    Side a(version), b(other);
    separate(a, b);
    std::size_t sum = a.nodeBytes;
    for (const surfel::SurfelBlock* block : a.blocks)
        sum += block->bytes();
    return sum;
}

} // namespace tree
