// SurfelTree: the index and the storage of a model in one, immutable and shared between versions.
//
// A tree is a value of one pointer. Copying it costs nothing; every version keeps what it holds alive. `apply` returns
// a new version that shares all blocks and nodes that the edit did not touch, so that its cost follows the edit.
//
//     version 0:      root                 version 1:      root'
//                    /    \                               /     \ .
//                  A        B      --apply-->            A        B'        A, b1 are the same objects in both
//                 / \      / \                                   /  \ .
//               a1   a2  b1   b2                               b1    b2'
//
// Invariants, checked by validate():
//   - all blocks are at the same depth; a node has 1 to 8 children; only the root may have one child, but in trees put
//     beside each other;
//   - a node's child boxes are the exact unions of what is below, its child supports the exact maxima;
//   - block and surfel counts are exact; blocks are sealed, non-empty, finite, with positive supports;
//   - all blocks carry `layout()->words()` extra words.
// Blocks are numbered in tree order, 0 to blockCount()-1; numbers belong to one version.
//
// Threads: any number may read one version or derive new ones from it; nothing is ever written in place.
#pragma once

#include "core/base/progress.h"
#include "core/base/ray.h"
#include "core/surfel/surfel_block.h"
#include "core/tree/node.h"

#include <bitset>
#include <span>

namespace tree {

struct TreeShape;

/// What happens to one block of a version. A surfel that is both changed and removed is removed.
struct BlockEdit {
    std::uint32_t block = 0;                    ///< number of the block in the version edited
    surfel::BlockPtr changed;                   ///< sealed, same size, replaces the content; null: content stays
    std::bitset<surfel::blockCapacity> removed; ///< slots that go
};

/// A difference between two versions, as tools make it.
struct Edit {
    std::vector<BlockEdit> blocks; ///< ascending by block, no block twice
    surfel::SurfelList inserted;   ///< same words as the tree
    /// The layout from now on: same words, other flags; or other words, where each block is changed. Null: as it was.
    surfel::AttributeLayoutPtr layout;
    bool empty() const { return blocks.empty() && inserted.items.empty(); }
};

/// One surfel found by a search.
struct Neighbour {
    const surfel::SurfelBlock* block = nullptr;
    std::uint32_t blockNumber = 0;
    int slot = 0;
    float distanceSq = 0;
};

class SurfelTree {
  public:
    SurfelTree() = default;
    /// Morton-ordered build, in parallel. Same bits at any thread count. Surfels keep no order.
    /// REQUIRES: finite positions, supports > 0. Throws base::Cancelled.
    static SurfelTree build(const surfel::SurfelList& surfels, const base::Progress& progress = {});
    /// The tree of that shape, bit for bit, where it is the shape of these surfels in this order; else as above.
    static SurfelTree build(const surfel::SurfelList& surfels, const TreeShape& shape,
                            const base::Progress& progress = {});
    /// Models beside each other as one, for who only looks at them: all of their blocks under new roots, none copied.
    /// Cost: the number of trees times their depth. REQUIRES: layouts with the same words; the result's is the first's.
    static SurfelTree beside(std::span<const SurfelTree> trees);
    /// How the surfels are spread: with `surfels()` all that there is of a tree. In parallel, O(size).
    TreeShape shape() const;

    bool empty() const { return !m_root; }
    std::size_t size() const { return m_root ? m_root->surfelCount : 0; }
    std::uint32_t blockCount() const { return m_root ? m_root->blockCount : 0; }
    const surfel::AttributeLayoutPtr& layout() const { return m_layout; }
    /// The same surfels under a layout with the same words (flags such as `colours` may differ).
    SurfelTree withLayout(surfel::AttributeLayoutPtr layout) const;
    /// Tight box of all positions.
    base::Box3f bounds() const;
    float maxSupport() const;
    const NodePtr& root() const { return m_root; }
    bool operator==(const SurfelTree& o) const { return m_root == o.m_root; }

    /// New version with the edit done; returns *this for an empty edit. Same bits at any thread count.
    SurfelTree apply(const Edit& edit) const;

    surfel::BlockPtr block(std::uint32_t number) const;
    /// Calls fn(blockNumber, block) for every block in tree order; `block` is a const SurfelBlock&.
    template <class Fn>
    void forEachBlock(const Fn& fn) const;
    /// All surfels in tree order.
    surfel::SurfelList surfels() const;
    /// Of each block the number of its first surfel in tree order, and after them `size()`.
    std::vector<std::size_t> firstSurfels() const;
    /// Sum of the surfels' hashes: the same for every tree of the same surfels. In parallel, O(size).
    base::Hash128 contentHash() const;
    /// Bytes of all blocks and nodes.
    std::size_t bytes() const;

    // --- queries; those that call back visit in tree order unless they say otherwise; `block` is a const SurfelBlock&

    /// fn(block, cluster) for every cluster that may have weight at `x` (support query, tree/README 4.1), supports
    /// multiplied by `reach`.
    template <class Fn>
    void forClustersInSupport(const base::Vec3f& x, const Fn& fn, float reach = 1) const;
    /// fn(block, cluster) for every cluster that may have weight somewhere in `box`; a superset for each x in it.
    template <class Fn>
    void forClustersInSupport(const base::Box3f& box, const Fn& fn, float reach = 1) const;
    /// fn(blockNumber, block) for every block that may have weight somewhere in `box`, supports multiplied by `reach`.
    template <class Fn>
    void forBlocksInSupport(const base::Box3f& box, const Fn& fn, float reach = 1) const;
    /// fn(blockNumber, block) for every block that has a position within `radius` of `centre`, by its box.
    template <class Fn>
    void forBlocksInBall(const base::Vec3f& centre, float radius, const Fn& fn) const;
    /// The k nearest surfels, nearest first; fewer when the tree has fewer. Ties by block and slot.
    /// Only those closer than `maxDistance`.
    void nearest(const base::Vec3f& x, std::size_t k, std::vector<Neighbour>& out,
                 float maxDistance = std::numeric_limits<float>::infinity()) const;
    /// Walks the clusters whose surface bounds meet the ray, by ascending entry: fn(block, cluster, tEnter, tExit)
    /// returns false to stop. Front to back: when it is called with tEnter, nothing unseen begins before tEnter
    /// (tree/README 4.2).
    template <class Fn>
    void alongRay(const base::Rayf& ray, const Fn& fn) const;

    /// The clusters whose surface bounds meet the ray, the nearest first among those of a block and of a node, in no
    /// order on the whole: fn(block, cluster, tEnter, tExit) returns up to where clusters are still wanted, and never
    /// more than before. Faster than `alongRay`.
    template <class Fn>
    void nearRay(const base::Rayf& ray, const Fn& fn) const;

    /// Throws std::logic_error naming the first broken invariant.
    void validate() const;

  private:
    SurfelTree(NodePtr root, surfel::AttributeLayoutPtr layout)
        : m_root(std::move(root)), m_layout(std::move(layout)) {}
    NodePtr m_root;
    surfel::AttributeLayoutPtr m_layout = surfel::AttributeLayout::none();
};

/// Blocks of one version that another does not share.
struct Diff {
    std::vector<surfel::BlockPtr> removed; ///< in `from` only
    std::vector<surfel::BlockPtr> added;   ///< in `to` only
    bool empty() const { return removed.empty() && added.empty(); }
};

/// What must be dropped and loaded to turn `from` into `to`. Cost follows the unshared part, however paths moved.
Diff diff(const SurfelTree& from, const SurfelTree& to);

/// Bytes that `version` holds and `other` does not share: what keeping it beside `other` costs.
std::size_t unsharedBytes(const SurfelTree& version, const SurfelTree& other);

} // namespace tree

#include "core/tree/queries.inl"
