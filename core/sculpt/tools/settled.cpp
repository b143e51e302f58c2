#include "core/sculpt/tools/settled.h"

namespace sculpt {

/// fn(cell, selected block, slot, block) for all that is selected.
template <class Fn>
static void forCells(const tree::SurfelTree& tree, tree::Selection& which, const base::Vec3f& origin, float scale,
                     const Fn& fn) {
    for (tree::SelectedBlock& each : which) {
        const surfel::BlockPtr block = tree.block(each.block);
        for (int slot = 0; slot < block->size(); ++slot)
            if (each.slots[static_cast<std::size_t>(slot)])
                fn(base::cellOf(block->position(slot), origin, scale), each, slot, *block);
    }
}

tree::Selection Settled::drop(const tree::SurfelTree& tree, tree::Selection which, const Ball& ball,
                              const AtGoal& atGoal) {
    ++m_dabs;
    forCells(tree, which, m_origin, m_scale,
             [&](const base::Cell& cell, tree::SelectedBlock&, int slot, const surfel::SurfelBlock& block) {
                 Place& place = m_places.at(cell);
                 if (place.dab != m_dabs)
                     place.dab = m_dabs, place.there = true;
                 place.there = place.there && atGoal(block, slot);
             });
    forCells(tree, which, m_origin, m_scale,
             [&](const base::Cell& cell, tree::SelectedBlock& each, int slot, const surfel::SurfelBlock&) {
                 Place& place = m_places.at(cell);
                 if (place.dab == m_dabs) { // the first of its cell
                     place.dab = -m_dabs;
                     const base::Vec3f corner{float(cell.x), float(cell.y), float(cell.z)};
                     const base::Vec3f middle = m_origin + (corner + base::Vec3f{0.5f, 0.5f, 0.5f}) / m_scale;
                     const bool whole = distance(middle, ball.centre) + 0.87f / m_scale < ball.radius;
                     if (place.there && whole && place.times <= enough)
                         ++place.times;
                 }
                 if (place.there && place.times > enough)
                     each.slots.reset(static_cast<std::size_t>(slot));
             });
    std::erase_if(which, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return which;
}

} // namespace sculpt
