// Applying an edit: insertions descend to their blocks, the touched level-1 nodes recut their touched blocks, each on
// its own and therefore in parallel, and the path above is made anew (tree/README 3).
//
//     locate      insertion -> block whose box is nearest
//     collect     one LeafTask per touched level-1 node, in tree order
//     run         each task: replaced blocks, or a pool of touched blocks cut anew
//     assemble    bottom up; blocks are regrouped under the touched level-2 nodes, nodes where they became too many or
//                 too few for their parent
#include "core/base/parallel.h"
#include "core/tree/regroup.h"
#include "core/tree/surfel_tree.h"

#include <cassert>

namespace tree {

namespace {

struct Insertion {
    std::uint32_t block, index;
};

/// Edits and insertions that fall into a range of blocks.
struct Slice {
    std::span<const BlockEdit> edits;
    std::span<const Insertion> insertions;

    bool empty() const { return edits.empty() && insertions.empty(); }
    /// What falls below block number `end`, taken off the front.
    Slice takeBelow(std::uint32_t end) {
        std::size_t e = 0, i = 0;
        while (e < edits.size() && edits[e].block < end)
            ++e;
        while (i < insertions.size() && insertions[i].block < end)
            ++i;
        const Slice front{edits.first(e), insertions.first(i)};
        edits = edits.subspan(e), insertions = insertions.subspan(i);
        return front;
    }
};

/// A touched level-1 node and the blocks that replace its own.
struct LeafTask {
    const Node* node;
    std::uint32_t firstBlock;
    Slice slice;
    Rebuilt result;
};

/// Block whose box is nearest, by a greedy descent; among boxes that hold x the one with the nearest centre.
std::uint32_t blockFor(const Node& root, const base::Vec3f& x) {
    std::uint32_t number = 0;
    for (const Node* node = &root;;) {
        float distance[fanOut];
        node->distanceSq(x, distance);
        int best = 0;
        float bestCentre = base::distanceSq(node->box(0).centre(), x);
        for (int i = 1; i < node->childCount; ++i) {
            const float centre = base::distanceSq(node->box(i).centre(), x);
            if (distance[i] < distance[best] || (distance[i] == distance[best] && centre < bestCentre))
                best = i, bestCentre = centre;
        }
        number += node->firstBlock[best];
        if (node->level == 1)
            return number;
        node = node->nodes[static_cast<std::size_t>(best)].get();
    }
}

std::vector<Insertion> locate(const Node& root, const surfel::SurfelList& inserted) {
    std::vector<Insertion> out(inserted.size());
    base::parallelFor(out.size(), 512, [&](std::size_t i) {
        requireValid(inserted.items[i], i);
        out[i] = {blockFor(root, inserted.items[i].position), static_cast<std::uint32_t>(i)};
    });
    std::sort(out.begin(), out.end(), [](const Insertion& a, const Insertion& b) {
        return a.block != b.block ? a.block < b.block : a.index < b.index;
    });
    return out;
}

void collect(const Node& node, std::uint32_t first, Slice slice, std::vector<LeafTask>& tasks) {
    if (node.level == 1) {
        tasks.push_back({&node, first, slice, {}});
        return;
    }
    for (int i = 0; i < node.childCount && !slice.empty(); ++i) {
        const std::uint32_t begin = first + node.firstBlock[i];
        const Slice part = slice.takeBelow(begin + node.blocksIn(i));
        if (!part.empty())
            collect(*node.nodes[static_cast<std::size_t>(i)], begin, part, tasks);
    }
}

class Application {
  public:
    Application(const SurfelTree& tree, const Edit& edit)
        : m_tree(tree), m_inserted(edit.inserted), m_words((edit.layout ? edit.layout : tree.layout())->words()),
          m_insertions(locate(*tree.root(), edit.inserted)) {
        collect(*tree.root(), 0, {edit.blocks, m_insertions}, m_tasks);
    }

    NodePtr run() {
        base::parallelFor(m_tasks.size(), 1, [&](std::size_t t) {
            m_tasks[t].result = recutLeaf(*m_tasks[t].node, m_tasks[t].firstBlock, m_tasks[t].slice);
        });
        const Node& root = *m_tree.root();
        return rootAbove(root.level, assemble(root, 0).children);
    }

  private:
    Rebuilt recutLeaf(const Node& node, std::uint32_t firstBlock, Slice slice) const;
    /// The new children of a touched node, whose first block has number `first`.
    Rebuilt assemble(const Node& node, std::uint32_t first);

    const SurfelTree& m_tree;
    const surfel::SurfelList& m_inserted;
    std::size_t m_words;
    std::vector<Insertion> m_insertions;
    std::vector<LeafTask> m_tasks;
    std::size_t m_next = 0; ///< the first task that assemble has not met yet
};

Rebuilt Application::recutLeaf(const Node& node, std::uint32_t firstBlock, Slice slice) const {
    Rebuilt out{true, false, {}};
    BlockPool pool(m_inserted, m_words);
    for (int i = 0; i < node.childCount; ++i) {
        const Slice part = slice.takeBelow(firstBlock + node.firstBlock[i] + 1);
        Child child = childOf(node, i);
        std::bitset<surfel::blockCapacity> removed;
        for (const BlockEdit& edit : part.edits) {
            removed = edit.removed;
            if (edit.changed) {
                assert(edit.changed->size() == child.block->size());
                assert(edit.changed->extraWords() == m_words);
                child = asChild(edit.changed);
            }
        }
        if (removed.none() && part.insertions.empty()) {
            out.children.push_back(std::move(child));
            continue;
        }
        pool.add(child, removed);
        for (const Insertion& insertion : part.insertions)
            pool.insert(insertion.index);
    }
    out.restructured = !pool.empty();
    pool.cutInto(out.children);
    return out;
}

Rebuilt Application::assemble(const Node& node, std::uint32_t first) {
    if (node.level == 1)
        return std::move(m_tasks[m_next++].result);
    std::vector<Rebuilt> parts(node.childCount);
    bool restructured = false, fits = true;
    for (int i = 0; i < node.childCount; ++i) {
        const std::uint32_t begin = first + node.firstBlock[i];
        if (m_next == m_tasks.size() || m_tasks[m_next].firstBlock >= begin + node.blocksIn(i))
            continue;
        Rebuilt& part = parts[static_cast<std::size_t>(i)];
        part = assemble(*node.nodes[static_cast<std::size_t>(i)], begin);
        restructured |= part.restructured;
        fits &= part.children.size() >= 2 && part.children.size() <= fanOut;
    }
    if (node.level > 2 && fits) // parents of regrouped nodes keep them: regrouping there again gains nothing measurable
        restructured = false;
    return restructured ? regroup(node, parts) : replace(node, parts);
}

} // namespace

SurfelTree SurfelTree::apply(const Edit& edit) const {
    if (edit.empty())
        return *this;
    assert(!edit.layout || edit.layout->words() == m_layout->words() ||
           (edit.inserted.items.empty() && edit.blocks.size() == blockCount()));
    const std::size_t words = m_layout->words();
    if (!m_root) {
        assert(edit.blocks.empty());
        const bool fits = edit.inserted.layout->words() == words;
        return build(edit.inserted).withLayout(fits ? m_layout : edit.inserted.layout);
    }
    assert(edit.inserted.items.empty() || edit.inserted.layout->words() == words);
    assert(edit.blocks.empty() || edit.blocks.back().block < blockCount());
    for (std::size_t i = 1; i < edit.blocks.size(); ++i)
        assert(edit.blocks[i - 1].block < edit.blocks[i].block);
    return {Application(*this, edit).run(), edit.layout ? edit.layout : m_layout};
}

} // namespace tree
