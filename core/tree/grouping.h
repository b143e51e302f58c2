// Gathering blocks and nodes under parents: kd cuts through their centres, into parts of nearly equal number.
//
// Internal to the tree. `Child` is what a parent knows about a child, so that regrouping touches no child's memory.
#pragma once

#include "core/base/progress.h"
#include "core/tree/node.h"

#include <span>
#include <vector>

namespace tree {

/// One child of a node: a block, or a node. Owns what it points to.
struct Child {
    base::Box3f box;
    float maxSupport = 0;
    std::uint32_t surfels = 0, blocks = 0;
    bool deficient = false; ///< a node with one child or a block below the merging size: to be joined with another
    NodePtr node;
    surfel::BlockPtr block;
};
using Children = std::vector<Child>;

Child asChild(surfel::BlockPtr block);
Child asChild(NodePtr node);
/// Child `i` of a node, without looking into it.
Child childOf(const Node& node, int i);
/// Appends all children of a node.
void appendChildren(const Node& node, Children& out);

/// A node above 1 to 8 children of one level.
NodePtr makeNode(int level, std::span<const Child> children);

/// Nodes of `level` above any number of children, each with 2 to 8 of them, or one above a single child. Children of
/// one node keep their order. A node of `old` that has exactly the children of a new one is taken again.
Children groupUnder(int level, const Children& children, std::span<const NodePtr> old = {});

/// The blocks of a whole list, in parallel; throws base::Error for a surfel without a finite position or support.
Children blocksOf(const surfel::SurfelList& surfels, const base::Progress& progress);
/// Throws base::Error unless surfel `index` can stand in a tree: finite position, support > 0.
void requireValid(const surfel::Surfel& surfel, std::size_t index);

/// The root of a balanced tree above any number of blocks, at least one.
NodePtr buildAbove(const Children& blocks);

} // namespace tree
