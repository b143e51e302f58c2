#include "core/tree/surfel_tree.h"

#include <stdexcept>
#include <string>

namespace tree {

namespace {

void require(bool holds, const char* invariant, std::uint32_t block) {
    if (!holds)
        throw std::logic_error(std::string("surfel tree: ") + invariant + ", at block " + std::to_string(block));
}

/// What was found below a child.
struct Found {
    base::Box3f box;
    float maxSupport = 0;
    std::size_t surfels = 0;
    std::uint32_t blocks = 0;
};

Found check(const surfel::SurfelBlock& block, std::size_t extraWords, std::uint32_t number) {
    require(block.size() >= 1 && block.size() <= surfel::blockCapacity, "a block's size is out of range", number);
    require(block.extraWords() == extraWords, "a block has other extra words than the layout", number);
    Found found;
    found.surfels = static_cast<std::size_t>(block.size()), found.blocks = 1;
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
        surfel::ClusterBounds exact;
        const int first = cluster * surfel::clusterSize;
        for (int slot = first; slot < std::min(first + surfel::clusterSize, block.size()); ++slot) {
            require(base::isFinite(block.position(slot)), "a position is not finite", number);
            require(block.support(slot) > 0 && std::isfinite(block.support(slot)), "a support is not positive", number);
            exact.box.extend(block.position(slot));
            exact.maxSupport = std::max(exact.maxSupport, block.support(slot));
        }
        require(block.bounds(cluster).box == exact.box, "a cluster's box is not tight: not sealed", number);
        require(block.bounds(cluster).maxSupport == exact.maxSupport, "a cluster's support is not exact", number);
        found.box.extend(exact.box);
        found.maxSupport = std::max(found.maxSupport, exact.maxSupport);
    }
    require(block.box() == found.box && block.maxSupport() == found.maxSupport, "a block's bounds are not exact",
            number);
    return found;
}

Found check(const Node& node, bool isRoot, std::size_t extraWords, std::uint32_t first) {
    require(node.childCount >= (isRoot && node.level == 1 ? 1 : 2) && node.childCount <= fanOut,
            "a node's number of children is out of range", first);
    Found found;
    for (int i = 0; i < fanOut; ++i) {
        const auto lane = static_cast<std::size_t>(i);
        const bool used = i < node.childCount;
        require((used && node.level > 1) == bool(node.nodes[lane]), "a node pointer is missing or too many", first);
        require((used && node.level == 1) == bool(node.blocks[lane]), "a block pointer is missing or too many", first);
        if (!used) {
            require(node.box(i) == base::Box3f() && node.maxSupport[i] == 0, "an unused lane is not empty", first);
            continue;
        }
        require(node.firstBlock[i] == found.blocks, "a child's first block number is wrong", first);
        const std::uint32_t number = first + found.blocks;
        require(node.level == 1 || node.nodes[lane]->level == node.level - 1, "blocks at different depths", number);
        const Found child = node.level == 1 ? check(*node.blocks[lane], extraWords, number)
                                            : check(*node.nodes[lane], false, extraWords, number);
        require(node.box(i) == child.box, "a child's box is not the exact union", number);
        require(node.maxSupport[i] == child.maxSupport, "a child's support is not the exact maximum", number);
        require(node.surfelsIn[i] == child.surfels, "a child's surfel count is wrong", number);
        found.box.extend(child.box);
        found.maxSupport = std::max(found.maxSupport, child.maxSupport);
        found.surfels += child.surfels;
        found.blocks += child.blocks;
    }
    require(node.surfelCount == found.surfels, "a node's surfel count is wrong", first);
    require(node.blockCount == found.blocks, "a node's block count is wrong", first);
    return found;
}

} // namespace

void SurfelTree::validate() const {
    if (m_root)
        check(*m_root, true, m_layout->words(), 0);
}

} // namespace tree
