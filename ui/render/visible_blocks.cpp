#include "ui/render/visible_blocks.h"

namespace render {

namespace {
struct Walk {
    const ViewFrame& view;
    float reachOfSupport;
    std::vector<VisibleBlock>& out;

    void node(const tree::Node& node) const {
        for (std::size_t i = 0; i < node.childCount; ++i) {
            const base::Box3f box{{node.loX[i], node.loY[i], node.loZ[i]}, {node.hiX[i], node.hiY[i], node.hiZ[i]}};
            const ScreenBounds bounds = screenBounds(view, box, reachOfSupport * node.maxSupport[i]);
            if (!bounds.visible)
                continue;
            if (node.level > 1)
                this->node(*node.nodes[i]);
            else
                out.push_back({node.blocks[i].get(), bounds});
        }
    }
};
} // namespace

void visibleBlocks(const tree::SurfelTree& model, const ViewFrame& view, float reachOfSupport,
                   std::vector<VisibleBlock>& out) {
    out.clear();
    if (model.root())
        Walk{view, reachOfSupport, out}.node(*model.root());
}

} // namespace render
