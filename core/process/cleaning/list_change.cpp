#include "core/process/cleaning/list_change.h"

#include "core/surfel/shape.h"

namespace process {

tree::SurfelTree changed(const tree::SurfelTree& tree, const ListChange& change) {
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    const int shape = surfel::shapeChannel(*tree.layout());
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::BlockEdit of{number, {}, {}};
        surfel::MutableBlockPtr fresh;
        const auto writable = [&]() -> surfel::SurfelBlock& {
            if (!fresh)
                fresh = block.clone();
            return *fresh;
        };
        for (int slot = 0; slot < block.size(); ++slot, ++at) {
            if (!change.removed.empty() && change.removed[at]) {
                of.removed.set(static_cast<std::size_t>(slot));
                continue;
            }
            if (!change.positions.empty() && change.positions[at] != block.position(slot))
                writable().setPosition(slot, change.positions[at]);
            if (!change.normals.empty() && change.normals[at] != block.normal(slot))
                writable().setNormal(slot, change.normals[at]);
            if (!change.supports.empty() && change.supports[at] != block.support(slot))
                surfel::setBall(writable(), slot, shape, change.supports[at]);
        }
        if (fresh) {
            fresh->seal();
            of.changed = fresh;
        }
        if (of.changed || of.removed.any())
            edit.blocks.push_back(std::move(of));
    });
    const tree::SurfelTree out = edit.blocks.empty() ? tree : tree.apply(edit);
    return change.layout ? out.withLayout(change.layout) : out;
}

} // namespace process
