#include "core/render/splats/visible_blocks.h"

#include <algorithm>
#include <numbers>

namespace render {

namespace {

using tree::Node;

/// Nodes with fewer surfels than this have too little to gain.
constexpr std::size_t leastSurfels = 2 * surfel::blockCapacity;
/// The widest disc of a proxy in usual ones: where a node has wider ones, its blocks are drawn.
constexpr float widestDisc = 3;
/// Before a proxy is made: its usual radius is hardly less than this part of that of evenly spread samples.
constexpr float leastGrowth = 0.5f;
/// Splats that turn away by less than this (sine) still show at outlines.
constexpr float awayBy = 0.2f;
/// Discs of smaller radius in the image are drawn as they are, as are those that stand out by less, both in pixels.
constexpr float finerPx = 6, standOutPx = 0.75f;
/// Surfels that lie off the surface by less are drawn where they are.
constexpr float offPx = 0.35f;

/// A child as its parent knows it, or the root.
struct NodeExtent {
    base::Box3f box;
    float support;
};

NodeExtent extentOf(const Node& node, std::size_t i) {
    return {{{node.loX[i], node.loY[i], node.loZ[i]}, {node.hiX[i], node.hiY[i], node.hiZ[i]}}, node.maxSupport[i]};
}

NodeExtent extentOf(const tree::SurfelTree& model) {
    return {model.bounds(), model.maxSupport()};
}

class Looker {
  public:
    explicit Looker(const Sight& sight) : m_sight(sight) {}

    ScreenBounds bounds(const NodeExtent& extent) const {
        return screenBounds(m_sight.view, extent.box, m_sight.standOut * m_sight.reachOfSupport * extent.support);
    }
    ScreenBounds bounds(const surfel::SurfelBlock& block) const {
        return screenBounds(m_sight.view, block.box(), m_sight.standOut * m_sight.reachOfSupport * block.maxSupport());
    }
    /// Whether it pays to know the node's detail.
    bool wants(const Node& node, const NodeExtent& extent, const ScreenBounds& bounds) const {
        if (!m_sight.details)
            return false;
        const float growth = std::sqrt(static_cast<float>(node.surfelCount) / surfel::blockCapacity);
        const bool small =
            node.surfelCount >= leastSurfels &&
            pixels(leastGrowth * growth * m_sight.reachOfSupport * extent.support, bounds) <= m_sight.detailPx;
        return small || m_sight.closed;
    }
    /// What is drawn instead of what is below; null: nothing, descend.
    const NodeDetail* instead(const Node& node, const NodeExtent& extent, const ScreenBounds& bounds) const {
        if (!wants(node, extent, bounds) || node.surfelCount < leastSurfels)
            return nullptr;
        const NodeDetail& detail = m_sight.details->of(node);
        const float widest = m_sight.reachOfSupport * detail.proxy->maxSupport();
        return pixels(detail.radius, bounds) <= m_sight.detailPx &&
                       pixels(widest, bounds) <= widestDisc * m_sight.detailPx
                   ? &detail
                   : nullptr;
    }
    /// All of it faces away. `reach`: what its splats may stand out of the extent.
    bool away(const Node& node, const NodeExtent& extent) const {
        if (!m_sight.closed || !m_sight.details || m_sight.view.clipCount > 0) // cut open, the inside shows
            return false;
        const NormalCone& cone = m_sight.details->of(node).cone;
        if (cone.all())
            return false;
        if (m_sight.view.parallel)
            return std::acos(std::clamp(dot(m_sight.view.forward, cone.axis), -1.0f, 1.0f)) + cone.angleRad + awayBy <
                   std::numbers::pi_v<float> / 2;
        const base::Vec3f to = extent.box.centre() - m_sight.view.eye;
        const float distance = length(to);
        const float radius = 0.5f * extent.box.diagonal() + m_sight.reachOfSupport * extent.support;
        if (!(distance > radius))
            return false;
        const float facing = std::acos(std::clamp(dot(to, cone.axis) / distance, -1.0f, 1.0f));
        return facing + cone.angleRad + std::asin(radius / distance) + awayBy < std::numbers::pi_v<float> / 2;
    }
    /// Whether anything drawn for the node can touch the tiles: discs of proxies may stand out of the node's bounds.
    bool touches(const TileMask* only, ScreenBounds b) const {
        if (!only)
            return true;
        const int more = m_sight.details ? static_cast<int>(std::ceil(widestDisc * m_sight.detailPx)) + 1 : 0;
        b.left = std::max(0, b.left - more), b.top = std::max(0, b.top - more);
        b.right = std::min(m_sight.view.width - 1, b.right + more);
        b.bottom = std::min(m_sight.view.height - 1, b.bottom + more);
        return only->touches(b);
    }

    /// How long a length at the nearest depth is in the image.
    float pixels(float length, const ScreenBounds& bounds) const {
        if (m_sight.view.parallel)
            return length * m_sight.view.focalPx;
        return bounds.nearest > 0 ? length * m_sight.view.focalPx / bounds.nearest
                                  : std::numeric_limits<float>::infinity();
    }

    /// How long a pixel is at the nearest depth, to an octave, so that moving a little makes nothing anew.
    float pixelNear(const ScreenBounds& bounds) const {
        const float perUnit = pixels(1, bounds);
        return std::isfinite(perUnit) && perUnit > 0 ? std::exp2(-std::round(std::log2(perUnit)))
                                                     : std::numeric_limits<float>::min();
    }

  private:
    const Sight& m_sight;
};

/// Calls block(block, bounds) and proxy(detail) for what is drawn of a version.
template <class Block, class Proxy>
struct Walk {
    const Looker& look;
    const TileMask* only;
    Block block;
    Proxy proxy;

    void node(const Node& node, const NodeExtent& extent) {
        const ScreenBounds bounds = look.bounds(extent);
        if (!bounds.visible || !look.touches(only, bounds) || look.away(node, extent))
            return;
        if (const NodeDetail* detail = look.instead(node, extent, bounds))
            proxy(*detail);
        else
            below(node);
    }
    void below(const Node& node) {
        for (std::size_t i = 0; i < node.childCount; ++i)
            if (node.level > 1)
                this->node(*node.nodes[i], extentOf(node, i));
            else
                block(*node.blocks[i], look.bounds(extentOf(node, i)));
    }
};

template <class Block, class Proxy>
Walk<Block, Proxy> walkOf(const Looker& look, const TileMask* only, Block block, Proxy proxy) {
    return {look, only, block, proxy};
}

/// Nodes whose detail a walk will ask for.
void gatherWanted(const Looker& look, const Node& node, const NodeExtent& extent, std::vector<const Node*>& out) {
    const ScreenBounds bounds = look.bounds(extent);
    if (!bounds.visible)
        return;
    if (look.wants(node, extent, bounds))
        out.push_back(&node);
    else if (node.level > 1)
        for (std::size_t i = 0; i < node.childCount; ++i)
            gatherWanted(look, *node.nodes[i], extentOf(node, i), out);
}

/// Both versions side by side, down to where they share.
struct Comparison {
    const Looker& look;
    TileMask& out;

    void all(const Node& node, const NodeExtent& extent) const {
        walkOf(
            look, nullptr, [&](const surfel::SurfelBlock&, const ScreenBounds& bounds) { add(bounds); },
            [&](const NodeDetail& detail) { add(look.bounds(*detail.proxy)); })
            .node(node, extent);
    }
    void add(const ScreenBounds& bounds) const {
        if (bounds.visible)
            out.add(bounds);
    }
    bool whole(const Node& node, const NodeExtent& extent) const {
        const ScreenBounds bounds = look.bounds(extent);
        return !bounds.visible || look.away(node, extent) || look.instead(node, extent, bounds);
    }
    void nodes(const Node& a, const NodeExtent& extentA, const Node& b, const NodeExtent& extentB) const {
        if (&a == &b)
            return;
        if (a.level != b.level || whole(a, extentA) || whole(b, extentB)) {
            all(a, extentA);
            all(b, extentB);
            return;
        }
        for (std::size_t i = 0; i < std::max<std::size_t>(a.childCount, b.childCount); ++i)
            children(a, b, i);
    }
    void child(const Node& node, std::size_t i) const {
        if (node.level > 1)
            all(*node.nodes[i], extentOf(node, i));
        else
            add(look.bounds(extentOf(node, i)));
    }
    void children(const Node& a, const Node& b, std::size_t i) const {
        const bool inA = i < a.childCount, inB = i < b.childCount;
        if (inA && inB && a.level > 1)
            return nodes(*a.nodes[i], extentOf(a, i), *b.nodes[i], extentOf(b, i));
        if (inA && inB && a.blocks[i] == b.blocks[i])
            return;
        if (inA)
            child(a, i);
        if (inB)
            child(b, i);
    }
};

} // namespace

void visibleBlocks(const tree::SurfelTree& model, const Sight& sight, std::vector<VisibleBlock>& out,
                   const TileMask* only) {
    const Looker look(sight);
    out.clear();
    if (!model.root())
        return;
    if (sight.details && !only) {
        std::vector<const Node*> wanted;
        gatherWanted(look, *model.root(), extentOf(model), wanted);
        sight.details->prepare(wanted);
    }
    const auto add = [&](const surfel::SurfelBlock& block, const ScreenBounds& bounds, bool proxy) {
        if (bounds.visible && (!only || only->touches(bounds)))
            out.push_back({&block, bounds, proxy, false, nullptr});
    };
    walkOf(
        look, only, [&](const surfel::SurfelBlock& block, const ScreenBounds& bounds) { add(block, bounds, false); },
        [&](const NodeDetail& d) { add(*d.proxy, look.bounds(*d.proxy), true); })
        .node(*model.root(), extentOf(model));
}

void findCuts(const Sight& sight, DiscCuts& cuts, std::span<VisibleBlock> blocks) {
    const Looker look(sight);
    std::vector<const surfel::SurfelBlock*> wanted;
    for (VisibleBlock& each : blocks) {
        each.large =
            !each.proxy && !(look.pixels(sight.reachOfSupport * each.block->maxSupport(), each.bounds) < cutPx);
        if (each.large)
            wanted.push_back(each.block);
    }
    cuts.prepare(wanted);
    for (VisibleBlock& each : blocks)
        if (each.large)
            each.cuts = cuts.of(each.block);
}

void findFiner(const Sight& sight, FinerBlocks& finer, std::vector<VisibleBlock>& blocks) {
    const Looker look(sight);
    const auto within = [&](float leastPx) {
        std::vector<std::size_t> out;
        for (std::size_t i = 0; i < blocks.size(); ++i)
            if (!blocks[i].proxy &&
                !(look.pixels(sight.reachOfSupport * blocks[i].block->maxSupport(), blocks[i].bounds) < leastPx))
                out.push_back(i);
        return out;
    };
    const auto blocksAt = [&](const std::vector<std::size_t>& at) {
        std::vector<const surfel::SurfelBlock*> out;
        for (const std::size_t i : at)
            out.push_back(blocks[i].block);
        return out;
    };
    std::vector<FinerBlocks::Wish> wishes;
    std::vector<bool> replaced(blocks.size());
    const auto wish = [&](std::size_t i, bool spread) {
        if (replaced[i])
            return;
        replaced[i] = true;
        wishes.push_back({blocks[i].block, spread, blocks[i].large, sight.pixelScale * look.pixelNear(blocks[i].bounds),
                          blocks[i].cuts});
    };
    const auto endsLarge = [&](const VisibleBlock& each) {
        for (int slot = 0; finer.bounded() && each.cuts && slot < each.block->size(); ++slot)
            if ((*each.cuts)[static_cast<std::size_t>(slot)] != wholeDisc &&
                !(look.pixels(sight.reachOfSupport * each.block->support(slot), each.bounds) < finerPx))
                return true;
        return false;
    };
    const std::vector<std::size_t> large = within(finerPx), any = within(offPx);
    const std::vector<float> standOut = finer.standOut(blocksAt(large));
    for (std::size_t k = 0; k < large.size(); ++k)
        if (look.pixels(standOut[k], blocks[large[k]].bounds) >= standOutPx || endsLarge(blocks[large[k]]))
            wish(large[k], true);
    const std::vector<float> off = finer.offSurface(blocksAt(any));
    for (std::size_t k = 0; k < any.size(); ++k)
        if (look.pixels(off[k], blocks[any[k]].bounds) >= offPx)
            wish(any[k], false);
    finer.prepare(wishes);
    std::vector<VisibleBlock> out;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (!replaced[i]) {
            out.push_back(blocks[i]);
            continue;
        }
        for (const FinerBlocks::Part& part : finer.of(blocks[i].block))
            out.push_back({part.block.get(), look.bounds(*part.block), true, true, part.cuts.get()});
    }
    blocks = std::move(out);
}

void addTiles(std::span<const surfel::SurfelBlock* const> blocks, const Sight& sight, TileMask& out) {
    const Looker look(sight);
    for (const surfel::SurfelBlock* block : blocks)
        if (const ScreenBounds bounds = look.bounds(*block); bounds.visible)
            out.add(bounds);
}

void addChangedTiles(const tree::SurfelTree& from, const tree::SurfelTree& to, const Sight& sight, TileMask& out) {
    const Looker look(sight);
    const Comparison compare{look, out};
    if (from.root() && to.root())
        compare.nodes(*from.root(), extentOf(from), *to.root(), extentOf(to));
    else if (from.root())
        compare.all(*from.root(), extentOf(from));
    else if (to.root())
        compare.all(*to.root(), extentOf(to));
}

} // namespace render
