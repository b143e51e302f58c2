#include "core/render/splats/detail_cache.h"

#include "core/base/parallel.h"

namespace render {

using tree::Node;

void DetailCache::use(float radiusOfSupport, bool oriented) {
    if (radiusOfSupport == m_radiusOfSupport && oriented == m_oriented)
        return;
    for (auto& [node, kept] : m_details)
        m_dropped.push_back(std::move(kept.detail.proxy));
    m_details.clear();
    m_radiusOfSupport = radiusOfSupport;
    m_oriented = oriented;
}

/// Whether something below has other colours than those in use.
bool DetailCache::dropRecoloured(const Node& node, const BlockColours* colours) {
    const auto of = [](const BlockColours* table, const surfel::SurfelBlock* block) {
        return table ? table->of(block) : nullptr;
    };
    bool changed = false;
    for (std::size_t i = 0; i < node.childCount; ++i)
        if (node.level > 1)
            changed |= dropRecoloured(*node.nodes[i], colours);
        else
            changed |= of(colours, node.blocks[i].get()) != of(m_colours.get(), node.blocks[i].get());
    if (changed)
        drop(node);
    return changed;
}

void DetailCache::colourBy(const tree::SurfelTree& version, std::shared_ptr<const BlockColours> colours) {
    if (colours == m_colours)
        return;
    if (!m_details.empty() && version.root())
        dropRecoloured(*version.root(), colours.get());
    m_colours = std::move(colours);
}

const NodeDetail* DetailCache::find(const Node& node) const {
    const auto found = m_details.find(&node);
    return found == m_details.end() ? nullptr : &found->second.detail;
}

/// REQUIRES: the children's were made.
NodeDetail DetailCache::make(const Node& node) const {
    std::array<const surfel::SurfelBlock*, tree::fanOut> parts{};
    std::array<NormalCone, tree::fanOut> cones;
    for (std::size_t i = 0; i < node.childCount; ++i)
        if (node.level == 1) {
            parts[i] = node.blocks[i].get();
            cones[i] = coneOf(*parts[i]);
        } else {
            const NodeDetail* below = find(*node.nodes[i]);
            parts[i] = below->proxy.get();
            cones[i] = below->cone;
        }
    NodeDetail out;
    out.proxy = representatives({parts.data(), node.childCount}, m_radiusOfSupport, m_oriented, m_colours.get());
    out.cone = m_oriented ? coneOf(std::span(cones).first(node.childCount)) : NormalCone{};
    float sum = 0;
    for (int i = 0; i < out.proxy->size(); ++i)
        sum += out.proxy->support(i) * out.proxy->support(i);
    out.radius = m_radiusOfSupport * std::sqrt(sum / static_cast<float>(out.proxy->size()));
    return out;
}

const NodeDetail& DetailCache::of(const Node& node) {
    if (const NodeDetail* found = find(node))
        return *found;
    if (node.level > 1)
        for (std::size_t i = 0; i < node.childCount; ++i)
            of(*node.nodes[i]);
    ++m_made;
    return m_details.try_emplace(&node, Kept{tree::NodePtr(&node), make(node)}).first->second.detail;
}

void DetailCache::prepare(std::span<const Node* const> nodes) {
    std::vector<std::vector<const Node*>> missing; // by level
    const auto gather = [&](const auto& self, const Node& node) -> void {
        if (find(node))
            return;
        if (missing.size() <= node.level)
            missing.resize(node.level + std::size_t(1));
        missing[node.level].push_back(&node);
        if (node.level > 1)
            for (std::size_t i = 0; i < node.childCount; ++i)
                self(self, *node.nodes[i]);
    };
    for (const Node* node : nodes)
        gather(gather, *node);
    for (const auto& level : missing) {
        std::vector<NodeDetail> made(level.size());
        base::parallelFor(level.size(), 8, [&](std::size_t i) { made[i] = make(*level[i]); });
        for (std::size_t i = 0; i < level.size(); ++i)
            m_details.try_emplace(level[i], Kept{tree::NodePtr(level[i]), std::move(made[i])});
        m_made += level.size();
    }
}

void DetailCache::drop(const Node& node) {
    const auto found = m_details.find(&node);
    if (found == m_details.end())
        return;
    m_dropped.push_back(std::move(found->second.detail.proxy));
    m_details.erase(found);
}

/// All of `a`'s that are not `b`'s; `b` may be null.
void DetailCache::dropBelow(const Node& a, const Node* b) {
    if (&a == b)
        return;
    const bool alike = b && a.level == b->level;
    if (a.level > 1)
        for (std::size_t i = 0; i < a.childCount; ++i)
            dropBelow(*a.nodes[i], alike && i < b->childCount ? b->nodes[i].get() : nullptr);
    drop(a);
}

void DetailCache::forget(const tree::SurfelTree& from, const tree::SurfelTree& to) {
    if (!m_details.empty() && from.root())
        dropBelow(*from.root(), to.root().get());
}

std::size_t DetailCache::bytes() const {
    std::size_t sum = 0;
    for (const auto& [node, kept] : m_details)
        sum += kept.detail.proxy->bytes();
    return sum;
}

} // namespace render
