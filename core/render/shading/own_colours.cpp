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

Shading usualShading(const tree::SurfelTree& tree) {
    return hasOwnColours(tree) ? Shading::Colour : Shading::Matcap;
}

} // namespace render
