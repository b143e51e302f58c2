#include "core/sculpt/tools/turns.h"

#include <algorithm>
#include <tuple>

namespace sculpt {

struct Turns::Here {
    Place* place;
    std::size_t count;
    float nearestSq; ///< to the brush's centre
};

static bool before(const base::Vec3f& a, const base::Vec3f& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// fn(position, selected block, slot) for all that is selected.
template <class Selected, class Fn>
static void forSelected(const tree::SurfelTree& tree, Selected& selection, const Fn& fn) {
    for (auto& each : selection) {
        const surfel::BlockPtr block = tree.block(each.block);
        for (int slot = 0; slot < block->size(); ++slot)
            if (each.slots[static_cast<std::size_t>(slot)])
                fn(block->position(slot), each, static_cast<std::size_t>(slot));
    }
}

std::vector<Turns::Here> Turns::placesOf(const tree::SurfelTree& tree, const tree::Selection& under,
                                         const base::Vec3f& centre) {
    std::map<std::uint64_t, Here> found;
    Here* last = nullptr;
    std::uint64_t lastKey = 0;
    forSelected(tree, under, [&](const base::Vec3f& p, const tree::SelectedBlock&, std::size_t) {
        const base::Cell cell = cellAt(p);
        if (!last || cell.key() != lastKey) { // most lie in the cell of the one before
            Place& place = m_places[lastKey = cell.key()];
            place.cell = cell;
            last = &found.try_emplace(lastKey, Here{&place, 0, distanceSq(p, centre)}).first->second;
        }
        ++last->count;
        last->nearestSq = std::min(last->nearestSq, distanceSq(p, centre));
    });
    std::vector<Here> out;
    for (const auto& [key, each] : found)
        out.push_back(each);
    return out;
}

/// Gives some their turn in this dab.
void Turns::choose(std::vector<Here>& here) {
    for (Here& each : here)
        ++each.place->waited;
    std::stable_sort(here.begin(), here.end(), [](const Here& a, const Here& b) {
        return std::make_tuple(-a.place->waited, a.nearestSq) < std::make_tuple(-b.place->waited, b.nearestSq);
    });
    std::size_t count = 0;
    for (const Here& each : here) {
        if (count >= atOnce)
            break;
        count += each.count;
        each.place->waited = 0;
        each.place->turn = m_dabs;
        each.place->left = {};
    }
}

void Turns::settle(Place& place) {
    std::sort(place.left.begin(), place.left.end(), before);
    place.left.erase(std::unique(place.left.begin(), place.left.end()), place.left.end());
    place.known = place.left.size();
}

void Turns::leave(Place& place, const base::Vec3f& p) {
    place.left.push_back(p);
    if (place.left.size() > 2 * place.known + 256) // most is there already, from the dabs before
        settle(place);
}

tree::Selection Turns::next(const tree::SurfelTree& tree, const tree::Selection& under, const base::Vec3f& centre) {
    ++m_dabs;
    std::vector<Here> here = placesOf(tree, under, centre);
    choose(here);
    tree::Selection out = under;
    Place* place = nullptr;
    std::uint64_t lastKey = 0;
    forSelected(tree, out, [&](const base::Vec3f& p, tree::SelectedBlock& each, std::size_t slot) {
        if (const std::uint64_t key = cellAt(p).key(); !place || key != lastKey)
            place = &m_places[lastKey = key];
        if (place->turn == m_dabs)
            return;
        each.slots.reset(slot);
        if (place->turn == 0)
            leave(*place, p);
    });
    std::erase_if(out, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return out;
}

tree::Selection Turns::rest(const tree::SurfelTree& tree) {
    std::map<std::uint32_t, std::bitset<surfel::blockCapacity>> found;
    std::size_t count = 0;
    const float halfDiagonal = 0.87f / m_scale; // of a cell, with room for rounding
    for (auto& [key, place] : m_places) {
        if (count >= atOnce)
            break;
        if (place.left.empty())
            continue;
        settle(place);
        const base::Vec3f middle{static_cast<float>(place.cell.x) + 0.5f, static_cast<float>(place.cell.y) + 0.5f,
                                 static_cast<float>(place.cell.z) + 0.5f};
        tree.forBlocksInBall(
            m_origin + middle / m_scale, halfDiagonal, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
                for (int slot = 0; slot < block.size(); ++slot)
                    if (std::binary_search(place.left.begin(), place.left.end(), block.position(slot), before))
                        found[number].set(static_cast<std::size_t>(slot)), ++count;
            });
        place.left = {};
        place.turn = m_dabs;
    }
    tree::Selection out;
    for (const auto& [number, slots] : found)
        out.push_back({number, slots});
    return out;
}

} // namespace sculpt
