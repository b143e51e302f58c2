#include "core/tree/regroup.h"

namespace tree {

/// Pools above this size are cut like a build: Morton runs in parallel instead of one kd recursion.
constexpr std::size_t largePool = 512 * blockTarget;

/// Index of the child whose centre is nearest to that of `box`, child `except` left out.
static std::size_t nearestChild(const Children& children, const base::Box3f& box, std::size_t except) {
    std::size_t best = children.size();
    float bestSq = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const float distanceSq = base::distanceSq(children[i].box.centre(), box.centre());
        if (i != except && (best == children.size() || distanceSq < bestSq))
            best = i, bestSq = distanceSq;
    }
    return best;
}

BlockPool::BlockPool(const surfel::SurfelList& inserted, std::size_t extraWords) : m_extraWords(extraWords) {
    m_pool.list = &inserted;
}

void BlockPool::add(const Child& block, const std::bitset<surfel::blockCapacity>& removed) {
    m_sources.push_back(block);
    m_pool.addBlock(*block.block, removed);
}

/// As many blocks as there were, as far as they stay between 3/4 full and full: an edit that moves a few surfels
/// changes no more of the structure than it must.
std::size_t BlockPool::blockNumber() const {
    const std::size_t count = m_pool.items.size();
    const std::size_t least = (count + surfel::blockCapacity - 1) / surfel::blockCapacity;
    const std::size_t most = std::max(blocksFor(count), count / (surfel::blockCapacity * 3 / 4));
    return std::clamp(m_sources.size(), least, most);
}

void BlockPool::cutInto(Children& siblings) {
    if (m_pool.items.empty())
        return;
    if (m_pool.items.size() < blockMinimum && !siblings.empty()) {
        base::Box3f box;
        for (const CutItem& item : m_pool.items)
            box.extend(base::Vec3f{item.position[0], item.position[1], item.position[2]});
        const auto nearest =
            siblings.begin() + static_cast<std::ptrdiff_t>(nearestChild(siblings, box, siblings.size()));
        add(*nearest);
        siblings.erase(nearest);
    }
    for (auto& block : m_pool.items.size() > largePool
                           ? cutLarge()
                           : cutIntoBlocks(m_pool, m_pool.items, blockNumber(), m_extraWords)) {
        siblings.push_back(asChild(std::move(block)));
        siblings.back().deficient = siblings.back().surfels < blockMinimum;
    }
}

std::vector<surfel::BlockPtr> BlockPool::cutLarge() const {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    for (std::size_t word = 0; word < m_extraWords; ++word)
        layout->add(std::to_string(word), surfel::ScalarType::UInt32);
    surfel::SurfelList list;
    list.layout = layout;
    std::vector<std::uint32_t> words(m_extraWords);
    for (const CutItem& item : m_pool.items) {
        if (item.source >= Pool::listBase) {
            const std::size_t index = item.source - Pool::listBase;
            list.append(m_pool.list->items[index], m_pool.list->extraOf(index));
            continue;
        }
        const surfel::SurfelBlock& block = *m_pool.blocks[item.source / surfel::blockCapacity];
        const int slot = static_cast<int>(item.source % surfel::blockCapacity);
        block.extra(slot, words);
        list.append(block.surfel(slot), words);
    }
    std::vector<surfel::BlockPtr> out;
    for (const Child& child : blocksOf(list, {}))
        out.push_back(child.block);
    return out;
}

/// Joins two children of the same level (0: blocks) into one or two that are not deficient, unless all that both hold
/// fits no better.
static Children join(int level, const Child& a, const Child& b);

/// Joins every deficient child with its nearest neighbour, as long as there are two.
static void repair(int level, Children& children) {
    const auto deficient = [](const Child& child) { return child.deficient; };
    while (children.size() > 1) {
        const auto found = std::find_if(children.begin(), children.end(), deficient);
        if (found == children.end())
            return;
        const auto i = static_cast<std::size_t>(found - children.begin());
        const std::size_t j = nearestChild(children, found->box, i);
        Children joined = join(level, children[i], children[j]);
        children.erase(children.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
        children.erase(children.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)));
        std::move(joined.begin(), joined.end(), std::back_inserter(children));
    }
}

static Children join(int level, const Child& a, const Child& b) {
    Children out;
    if (level == 0) {
        const surfel::SurfelList none;
        BlockPool pool(none, a.block->extraWords());
        pool.add(a);
        pool.add(b);
        pool.cutInto(out);
        return out;
    }
    appendChildren(*a.node, out);
    appendChildren(*b.node, out);
    for (Child& child : out)
        child.deficient = child.node ? child.node->childCount < 2 : child.surfels < blockMinimum;
    repair(level - 1, out);
    return groupUnder(level, out);
}

Rebuilt replace(const Node& node, std::span<const Rebuilt> parts) {
    Rebuilt out{true, false, {}};
    for (std::size_t i = 0; i < parts.size(); ++i)
        out.children.push_back(parts[i].touched ? asChild(makeNode(node.level - 1, parts[i].children))
                                                : childOf(node, static_cast<int>(i)));
    return out;
}

Rebuilt regroup(const Node& node, std::span<const Rebuilt> parts) {
    Children grandchildren;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].touched)
            grandchildren.insert(grandchildren.end(), parts[i].children.begin(), parts[i].children.end());
        else
            appendChildren(*node.nodes[i], grandchildren);
    }
    repair(node.level - 2, grandchildren);
    return {true, true, groupUnder(node.level - 1, grandchildren, node.nodes)};
}

NodePtr rootAbove(int level, Children children) {
    if (children.empty())
        return {};
    for (; children.size() > fanOut; ++level)
        children = groupUnder(level, children);
    NodePtr root = makeNode(level, children);
    while (root->level > 1 && root->childCount == 1)
        root = NodePtr(root->nodes[0]);
    return root;
}

} // namespace tree
