// The structural half of an edit: cutting touched blocks anew, joining what became too small, and regrouping the
// grandchildren of touched nodes, so that queries stay as fast as after a build.
//
// Internal to the tree.
#pragma once

#include "core/tree/cutting.h"
#include "core/tree/grouping.h"

namespace tree {

/// What became of a node: its new children, of the node's own level - 1, in any number.
struct Rebuilt {
    bool touched = false;
    bool restructured = false; ///< surfels moved between blocks somewhere below
    Children children;
};

/// Surfels of touched blocks and insertions on their way into new blocks.
class BlockPool {
  public:
    /// `inserted` must outlive the pool.
    BlockPool(const surfel::SurfelList& inserted, std::size_t extraWords);
    /// Takes what an edit leaves of a block.
    void add(const Child& block, const std::bitset<surfel::blockCapacity>& removed = {});
    /// Takes entry `index` of the inserted list.
    void insert(std::uint32_t index) { m_pool.addListed(index); }
    /// True before the first `add`.
    bool empty() const { return m_sources.empty(); }
    /// Cuts the pool into blocks and appends them to `siblings`; a pool too small for a block of its own first takes
    /// in the nearest sibling.
    void cutInto(Children& siblings);

  private:
    std::size_t blockNumber() const;
    std::vector<surfel::BlockPtr> cutLarge() const;

    Pool m_pool;
    Children m_sources; ///< keeps the blocks alive
    std::size_t m_extraWords;
};

/// The children of `node` where nothing below was restructured: untouched ones as they are, the others made anew.
Rebuilt replace(const Node& node, std::span<const Rebuilt> parts);
/// The children of `node` where something was: all grandchildren, too small ones joined, under new parents.
/// REQUIRES: level >= 2; parts[i] belongs to child i.
Rebuilt regroup(const Node& node, std::span<const Rebuilt> parts);

/// The root above any number of nodes of `level` - 1 (blocks for level 1): grows and shrinks; null for none.
NodePtr rootAbove(int level, Children children);

} // namespace tree
