#include "ui/render/visible_blocks.h"

#include <algorithm>

namespace render {

namespace {

struct Eye {
    const ViewFrame& view;
    float reachOfSupport;

    ScreenBounds bounds(const tree::Node& node, std::size_t i) const {
        const base::Box3f box{{node.loX[i], node.loY[i], node.loZ[i]}, {node.hiX[i], node.hiY[i], node.hiZ[i]}};
        return screenBounds(view, box, reachOfSupport * node.maxSupport[i]);
    }
};

struct Walk {
    const Eye& eye;
    const TileMask* only;
    std::vector<VisibleBlock>& out;

    void node(const tree::Node& node) const {
        for (std::size_t i = 0; i < node.childCount; ++i) {
            const ScreenBounds bounds = eye.bounds(node, i);
            if (!bounds.visible || (only && !only->touches(bounds)))
                continue;
            if (node.level > 1)
                this->node(*node.nodes[i]);
            else
                out.push_back({node.blocks[i].get(), bounds});
        }
    }
};

/// Both versions side by side, down to where they share.
struct Comparison {
    const Eye& eye;
    TileMask& out;

    void all(const tree::Node& node, std::size_t i) const {
        const ScreenBounds bounds = eye.bounds(node, i);
        if (!bounds.visible)
            return;
        if (node.level > 1)
            all(*node.nodes[i]);
        else
            out.add(bounds);
    }
    void all(const tree::Node& node) const {
        for (std::size_t i = 0; i < node.childCount; ++i)
            all(node, i);
    }
    void nodes(const tree::Node& a, const tree::Node& b) const {
        if (&a == &b)
            return;
        if (a.level != b.level) {
            all(a);
            all(b);
            return;
        }
        for (std::size_t i = 0; i < std::max<std::size_t>(a.childCount, b.childCount); ++i)
            children(a, b, i);
    }
    void children(const tree::Node& a, const tree::Node& b, std::size_t i) const {
        const bool inA = i < a.childCount, inB = i < b.childCount;
        if (inA && inB && a.level > 1)
            return nodes(*a.nodes[i], *b.nodes[i]);
        if (inA && inB && a.blocks[i] == b.blocks[i])
            return;
        if (inA)
            all(a, i);
        if (inB)
            all(b, i);
    }
};

} // namespace

void visibleBlocks(const tree::SurfelTree& model, const ViewFrame& view, float reachOfSupport,
                   std::vector<VisibleBlock>& out, const TileMask* only) {
    const Eye eye{view, reachOfSupport};
    out.clear();
    if (model.root())
        Walk{eye, only, out}.node(*model.root());
}

void addChangedTiles(const tree::SurfelTree& from, const tree::SurfelTree& to, const ViewFrame& view,
                     float reachOfSupport, TileMask& out) {
    const Eye eye{view, reachOfSupport};
    const Comparison compare{eye, out};
    if (from.root() && to.root())
        compare.nodes(*from.root(), *to.root());
    else if (from.root())
        compare.all(*from.root());
    else if (to.root())
        compare.all(*to.root());
}

} // namespace render
