#include "core/render/shading/own_colours.h"

namespace render {

bool hasOwnColours(const tree::SurfelTree& tree) {
    if (!tree.layout()->colours || tree.empty())
        return false;
    const surfel::Colour first = tree.block(0)->surfel(0).colour;
    for (std::uint32_t number = 0; number < tree.blockCount(); ++number) {
        const surfel::BlockPtr block = tree.block(number);
        for (int slot = 0; slot < block->size(); ++slot)
            if (block->surfel(slot).colour != first)
                return true;
    }
    return false;
}

/// By what a file of them leaves (io/README 2.17).
static bool areSplats(const surfel::AttributeLayout& layout) {
    return layout.find("opacity") && layout.find("scale_0") && layout.find("rot_0");
}

Shading usualShading(const tree::SurfelTree& tree) {
    if (!hasOwnColours(tree))
        return Shading::Matcap;
    return areSplats(*tree.layout()) ? Shading::Unlit : Shading::Colour;
}

} // namespace render
