#include "core/tree/with_surfels.h"

namespace tree {

SurfelTree withSurfels(const SurfelTree& tree, const surfel::SurfelList& surfels) {
    Edit edit;
    edit.layout = surfels.layout;
    edit.inserted.layout = surfels.layout;
    std::size_t next = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        surfel::MutableBlockPtr changed = surfel::SurfelBlock::create(block.size(), surfels.layout->words());
        for (int slot = 0; slot < block.size(); ++slot, ++next) {
            changed->set(slot, surfels.items[next]);
            changed->setExtra(slot, surfels.extraOf(next));
        }
        changed->seal();
        edit.blocks.push_back({number, changed, {}});
    });
    return tree.apply(edit);
}

} // namespace tree
