#include "core/tree/grouping.h"

#include "core/base/parallel.h"

#include <array>
#include <cassert>

namespace tree {

Child asChild(surfel::BlockPtr block) {
    Child child{block->box(), block->maxSupport(), static_cast<std::uint32_t>(block->size()), 1, false, {}, {}};
    child.block = std::move(block);
    return child;
}

Child asChild(NodePtr node) {
    Child child;
    for (int i = 0; i < node->childCount; ++i) {
        child.box.extend(node->box(i));
        child.maxSupport = std::max(child.maxSupport, node->maxSupport[i]);
    }
    child.surfels = static_cast<std::uint32_t>(node->surfelCount);
    child.blocks = node->blockCount;
    child.deficient = node->childCount < 2;
    child.node = std::move(node);
    return child;
}

Child childOf(const Node& node, int i) {
    const auto lane = static_cast<std::size_t>(i);
    return {node.box(i),         node.maxSupport[i], node.surfelsIn[i], node.blocksIn(i),
            /*deficient*/ false, node.nodes[lane],   node.blocks[lane]};
}

void appendChildren(const Node& node, Children& out) {
    for (int i = 0; i < node.childCount; ++i)
        out.push_back(childOf(node, i));
}

void requireValid(const surfel::Surfel& surfel, std::size_t index) {
    if (!base::isFinite(surfel.position))
        throw base::Error("a point has no finite position", "point " + std::to_string(index));
    if (!(surfel.support > 0) || !std::isfinite(surfel.support))
        throw base::Error("a point has no positive, finite support radius", "point " + std::to_string(index));
}

NodePtr makeNode(int level, std::span<const Child> children) {
    assert(!children.empty() && children.size() <= fanOut);
    auto* node = new Node;
    node->level = static_cast<std::uint8_t>(level);
    node->childCount = static_cast<std::uint8_t>(children.size());
    for (std::size_t i = 0; i < children.size(); ++i) {
        const Child& child = children[i];
        node->set(static_cast<int>(i), child.box, child.maxSupport);
        node->surfelsIn[i] = child.surfels;
        node->firstBlock[i] = node->blockCount;
        node->surfelCount += child.surfels;
        node->blockCount += child.blocks;
        node->nodes[i] = child.node;
        node->blocks[i] = child.block;
    }
    return NodePtr(node);
}

namespace {

struct Key {
    base::Vec3f centre;
    std::uint32_t index;
};

std::vector<Key> keysOf(const Children& children) {
    std::vector<Key> keys(children.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i] = {children[i].box.centre(), static_cast<std::uint32_t>(i)};
    return keys;
}

/// A way to cut: the first `middle` keys along `axis`, above `parts` parents.
struct Cut {
    std::size_t axis = 0, middle = 0, parts = 0;
    float cost = std::numeric_limits<float>::infinity();
};

/// A total order.
struct Before {
    std::size_t axis;
    bool operator()(const Key& a, const Key& b) const {
        return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.index < b.index;
    }
};

/// Half the surface of the region in which a support query meets the box.
float cost(const base::Box3f& box, float support) {
    const base::Vec3f s = box.size() + base::Vec3f{1, 1, 1} * (2 * support);
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// Tries the cuts along one axis that leave both sides room: surface area heuristic, each side weighed by its parents.
void tryAxis(std::span<Key> keys, std::size_t parts, std::size_t axis, const Children& children, Cut& best) {
    std::sort(keys.begin(), keys.end(), Before{axis});
    std::array<float, fanOut * fanOut * 2> before;
    base::Box3f box;
    float support = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        box.extend(children[keys[i].index].box);
        support = std::max(support, children[keys[i].index].maxSupport);
        before[i] = cost(box, support);
    }
    box = {}, support = 0;
    for (std::size_t i = keys.size() - 1; i > 0; --i) {
        box.extend(children[keys[i].index].box);
        support = std::max(support, children[keys[i].index].maxSupport);
        const std::size_t left = (i * parts + keys.size() / 2) / keys.size(), right = parts - left;
        if (left < 1 || right < 1 || i > left * fanOut || keys.size() - i > right * fanOut || i < 2 * left ||
            keys.size() - i < 2 * right)
            continue;
        const float sum = before[i - 1] * static_cast<float>(left) + cost(box, support) * static_cast<float>(right);
        if (sum < best.cost)
            best = {axis, i, left, sum};
    }
}

/// Cuts into `parts` runs across the longest side of the centres' box, of nearly equal length; few enough keys by the
/// cheapest cut instead.
template <class Fn>
void cut(std::span<Key> keys, std::size_t parts, const Children& children, const Fn& fn) {
    if (parts == 1)
        return fn(keys);
    Cut best;
    if (keys.size() <= fanOut * fanOut * 2 && keys.size() <= parts * fanOut)
        for (std::size_t axis = 0; axis < 3; ++axis)
            tryAxis(keys, parts, axis, children, best);
    if (best.parts == 0) {
        base::Box3f box;
        for (const Key& key : keys)
            box.extend(key.centre);
        const base::Vec3f size = box.size();
        best.axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        best.parts = parts / 2;
        best.middle = (keys.size() * best.parts + parts / 2) / parts;
    }
    const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(best.middle);
    std::nth_element(keys.begin(), middle, keys.end(), Before{best.axis});
    cut(keys.first(best.middle), best.parts, children, fn);
    cut(keys.subspan(best.middle), parts - best.parts, children, fn);
}

bool hasChildren(const Node& node, const Children& children) {
    if (node.childCount != children.size())
        return false;
    for (std::size_t i = 0; i < children.size(); ++i)
        if (!(node.nodes[i] == children[i].node && node.blocks[i] == children[i].block))
            return false;
    return true;
}

NodePtr nodeAbove(int level, std::span<Key> keys, const Children& children, std::span<const NodePtr> old = {}) {
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.index < b.index; });
    Children chosen;
    for (const Key& key : keys)
        chosen.push_back(children[key.index]);
    for (const NodePtr& node : old)
        if (node && hasChildren(*node, chosen))
            return node;
    return makeNode(level, chosen);
}

/// Blocks above which threads share the work.
constexpr std::size_t worthThreads = 1024;

NodePtr subtree(int level, std::span<Key> keys, const Children& blocks) {
    if (level == 1)
        return nodeAbove(level, keys, blocks);
    const std::size_t capacity = std::size_t(1) << (3 * (level - 1));
    std::vector<std::span<Key>> parts;
    cut(keys, (keys.size() + capacity - 1) / capacity, blocks, [&](std::span<Key> part) { parts.push_back(part); });
    Children children(parts.size());
    const std::size_t grain = keys.size() < worthThreads ? parts.size() : 1;
    base::parallelFor(parts.size(), grain,
                      [&](std::size_t i) { children[i] = asChild(subtree(level - 1, parts[i], blocks)); });
    return makeNode(level, children);
}

} // namespace

Children groupUnder(int level, const Children& children, std::span<const NodePtr> old) {
    if (children.empty())
        return {};
    std::vector<Key> keys = keysOf(children);
    Children out;
    cut(std::span(keys), (keys.size() + fanOut - 1) / fanOut, children,
        [&](std::span<Key> part) { out.push_back(asChild(nodeAbove(level, part, children, old))); });
    return out;
}

NodePtr buildAbove(const Children& blocks) {
    int level = 1;
    while (blocks.size() > std::size_t(1) << (3 * level))
        ++level;
    std::vector<Key> keys = keysOf(blocks);
    return subtree(level, keys, blocks);
}

} // namespace tree
