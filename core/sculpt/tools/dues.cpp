#include "core/sculpt/tools/dues.h"

#include <algorithm>
#include <tuple>

namespace sculpt {

/// Mean supports that differ by no more are about the same.
constexpr float sameSupport = 1.15f;
/// Less is not worth a turn.
constexpr float leastDue = 1e-3f;
/// So many times the surfels of a turn are looked at for those whose turn it is.
constexpr std::size_t lookedAt = 4;

base::Vec3f Dues::middleOf(const base::Cell& cell) const {
    const base::Vec3f corner{static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(cell.z)};
    return m_origin + (corner + base::Vec3f{0.5f, 0.5f, 0.5f}) / m_scale;
}

void Dues::owe(const tree::SurfelTree& tree, const base::Vec3f& centre, float radius, float strength) {
    const int dab = m_dabs++;
    std::map<std::uint64_t, base::Cell> under;
    tree.forBlocksInBall(centre, radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        const base::Box3f box = block.box();
        const base::Cell from = base::cellOf(box.lo, m_origin, m_scale), to = base::cellOf(box.hi, m_origin, m_scale);
        const auto add = [&](const base::Cell& cell) {
            if (distance(middleOf(cell), centre) < radius + reach())
                under.try_emplace(cell.key(), cell);
        };
        // as many cells as the block has surfels, or it is one of those that reach far: then each for itself
        const auto span = [](std::int64_t a, std::int64_t b) { return static_cast<double>(b - a) + 1; };
        if (span(from.x, to.x) * span(from.y, to.y) * span(from.z, to.z) > static_cast<double>(block.size())) {
            for (int slot = 0; slot < block.size(); ++slot)
                add(base::cellOf(block.position(slot), m_origin, m_scale));
            return;
        }
        for (std::int64_t x = from.x; x <= to.x; ++x)
            for (std::int64_t y = from.y; y <= to.y; ++y)
                for (std::int64_t z = from.z; z <= to.z; ++z)
                    add({x, y, z});
    });
    for (const auto& [key, cell] : under) {
        Place& place = m_places[key];
        place.cell = cell, place.last = dab;
        place.aside = distanceSq(middleOf(cell), centre);
        if (place.dab < 0 || place.aside < place.nearest)
            place.dab = dab, place.nearest = place.aside;
        place.due += strength;
    }
}

tree::Selection Dues::surfelsOf(const tree::SurfelTree& tree, const base::Cell& cell) const {
    tree::Selection out;
    const std::uint64_t key = cell.key();
    tree.forBlocksInBall(middleOf(cell), reach(), [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::SelectedBlock some{number, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            if (base::cellOf(block.position(slot), m_origin, m_scale).key() == key)
                some.slots.set(static_cast<std::size_t>(slot));
        if (some.slots.any())
            out.push_back(some);
    });
    return out;
}

namespace {

/// What cells have found, together.
class Gathering {
  public:
    void add(const tree::Selection& some) {
        for (const tree::SelectedBlock& each : some)
            m_slots[each.block] |= each.slots;
    }
    tree::Selection selection() const {
        tree::Selection out;
        for (const auto& [block, slots] : m_slots)
            out.push_back({block, slots});
        return out;
    }

  private:
    std::map<std::uint32_t, std::bitset<surfel::blockCapacity>> m_slots;
};

struct Supports {
    std::size_t count = 0;
    double sum = 0;

    Supports(const tree::SurfelTree& tree, const tree::Selection& of) {
        for (const tree::SelectedBlock& each : of) {
            const surfel::BlockPtr block = tree.block(each.block);
            for (int slot = 0; slot < block->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)])
                    ++count, sum += static_cast<double>(block->support(slot));
        }
    }
    float mean() const { return count > 0 ? static_cast<float>(sum / static_cast<double>(count)) : 0; }
    bool isLike(float other) const {
        return count == 0 || std::max(mean(), other) <= sameSupport * std::min(mean(), other);
    }
};

} // namespace

/// Gives some their turn.
Dues::Turn Dues::choose(std::vector<Place*> places, const Wanted& wanted) {
    std::stable_sort(places.begin(), places.end(), [](const Place* a, const Place* b) {
        return std::make_tuple(-a->due, a->aside) < std::make_tuple(-b->due, b->aside);
    });
    struct Chosen {
        Place* place;
        bool done; ///< with this turn
    };
    std::vector<Chosen> chosen;
    Gathering under, which;
    Supports all(wanted.tree, {});
    Turn out;
    out.strength = 1;
    std::size_t looked = 0;
    for (Place* const place : places) {
        if (all.count >= wanted.most || looked >= lookedAt * wanted.most)
            break;
        const tree::Selection surfels = surfelsOf(wanted.tree, place->cell);
        const Seen seen = wanted.look({surfels, middleOf(place->cell), reach()});
        const Supports of(wanted.tree, seen.which);
        looked += 1 + of.count;
        if (wanted.alike && all.count > 0 && !of.isLike(all.mean()))
            continue;
        if (seen.under.empty() || (seen.there && seen.whole && place->times >= wanted.turnsAtGoal)) {
            place->due = 0;
            continue;
        }
        place->times = seen.there ? place->times + 1 : 0;
        chosen.push_back({place, of.count == 0 || place->times >= wanted.turnsAtGoal});
        out.strength = std::min(out.strength, place->due);
        under.add(seen.under), which.add(seen.which);
        all.count += of.count, all.sum += of.sum;
    }
    for (const Chosen& each : chosen) {
        const float left = each.place->due - out.strength;
        each.place->due = each.done || left < leastDue ? 0 : left;
    }
    out.under = under.selection(), out.which = which.selection();
    out.support = all.mean();
    return out;
}

Dues::Turn Dues::next(const Wanted& wanted) {
    std::vector<Place*> places;
    for (auto& [key, place] : m_places)
        if (place.due > 0 && place.last == m_dabs - 1)
            places.push_back(&place);
    return choose(std::move(places), wanted);
}

std::optional<int> Dues::firstDab() const {
    std::optional<int> out;
    for (const auto& [key, place] : m_places)
        if (place.due > 0 && (!out || place.dab < *out))
            out = place.dab;
    return out;
}

Dues::Turn Dues::rest(int dab, const Wanted& wanted) {
    std::vector<Place*> places;
    for (auto& [key, place] : m_places)
        if (place.due > 0 && place.dab == dab) {
            place.aside = place.nearest;
            places.push_back(&place);
        }
    return choose(std::move(places), wanted);
}

void Dues::forgive(int dab) {
    for (auto& [key, place] : m_places)
        if (place.dab == dab)
            place.due = 0;
}

} // namespace sculpt
