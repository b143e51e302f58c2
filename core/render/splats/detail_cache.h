// The details (node_detail.h) of a shown version's nodes, made when first wanted and kept while the version holds the
// node: versions share nodes, so that an edit remakes what lies above its blocks and no more.
//
//     cache.use(radius, oriented)   before anything else in a frame
//     cache.prepare(nodes)          many at once, on all cores
//     cache.of(node)                one, with what it is made of
//     cache.forget(from, to)        when the next version is shown
//
// Memory: at most about a sixth of the version's blocks, where all of it was ever seen from afar. One thread; `find`
// may be called from several while nothing else is.
#pragma once

#include "core/render/splats/node_detail.h"
#include "core/tree/surfel_tree.h"

#include <unordered_map>

namespace render {

class DetailCache {
  public:
    /// What details depend on beside their node; forgets all of them if it changes.
    void use(float radiusOfSupport, bool oriented);
    /// Colours beside the blocks that proxies take instead of the blocks' own; drops the details of the version that
    /// have others below them. Cost: its blocks, where the table is another than before.
    void colourBy(const tree::SurfelTree& version, std::shared_ptr<const BlockColours> colours);
    /// Null where it was not made.
    const NodeDetail* find(const tree::Node& node) const;
    const NodeDetail& of(const tree::Node& node);
    void prepare(std::span<const tree::Node* const> nodes);
    /// Drops what `to` does not hold at the same place as `from`. Cost: what differs.
    void forget(const tree::SurfelTree& from, const tree::SurfelTree& to);

    std::size_t size() const { return m_details.size(); }
    /// Bytes of the proxies.
    std::size_t bytes() const;
    /// Counts every detail ever made; for tests and statistics.
    std::size_t made() const { return m_made; }
    /// Proxies dropped since the last call: whoever holds copies of them may drop those too.
    std::vector<surfel::BlockPtr> takeDropped() { return std::exchange(m_dropped, {}); }

  private:
    struct Kept {
        tree::NodePtr node; ///< keeps its address its own
        NodeDetail detail;
    };
    NodeDetail make(const tree::Node& node) const;
    void drop(const tree::Node& node);
    bool dropRecoloured(const tree::Node& node, const BlockColours* colours);
    void dropBelow(const tree::Node& a, const tree::Node* b);

    float m_radiusOfSupport = 0;
    bool m_oriented = false;
    std::shared_ptr<const BlockColours> m_colours;
    std::unordered_map<const tree::Node*, Kept> m_details;
    std::vector<surfel::BlockPtr> m_dropped;
    std::size_t m_made = 0;
};

} // namespace render
