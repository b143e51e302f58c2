// Parts of models, by where their surfels are and how these face.
#pragma once

#include "core/process/registering/rigid.h"
#include "core/tree/selection.h"

namespace test {

/// The surfels of which `fn(place, normal)` is true, of a model that stands in `pose`.
template <class Fn>
tree::Selection chosen(const tree::SurfelTree& tree, const process::Rigid& pose, const Fn& fn) {
    const process::Rigid back = pose.inverse();
    tree::Selection out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::SelectedBlock each{number, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            each.slots[std::size_t(slot)] =
                fn(back(base::cast<double>(block.position(slot))), back.turn(base::cast<double>(block.normal(slot))));
        if (each.slots.any())
            out.push_back(each);
    });
    return out;
}

} // namespace test
