// How far the dabs of a stroke have stretched and squeezed the surfels since their sampling was last seen to, and where
// each surfel comes from: what says where resampling is due, and which sampling is to be kept there.
//
// Two surfels that lay d apart then and lie d' apart now have the ratio d' / d, damped where d is far below that of
// other pairs. Each surfel that has moved has the largest and the smallest ratio over pairs of neighbours in its
// cluster, which point in all directions; a block has those of its surfels. What is carried along as one piece has 1.
// The smallest are taken along the surface, since noise and relief that is smoothed away brings nothing together.
//
// The origin of a surfel is its place on the version that the stroke began on; one that was born or moved by resampling
// has that of the surfel nearest to it.
//
// A value, used by one thread; works in parallel inside, the same bits at any thread count.
#pragma once

#include "core/base/parallel.h"
#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>

namespace sculpt {

/// The spacing around a place of a version.
struct LocalSpacing {
    bool known = false;
    bool steady = true; ///< the supports around are alike
    bool even = true;   ///< no two around are so near each other that the spacing is one of chance
    float value = 0;
};

struct StretchRange {
    float least = 1, most = 1;
    void unite(const StretchRange& o) {
        least = o.least < least ? o.least : least;
        most = o.most > most ? o.most : most;
    }
    bool within(const StretchRange& limits) const { return least >= limits.least && most <= limits.most; }
    /// 1 at one of the limits, 0 where nothing is stretched; in between and beyond by logarithms.
    float strain(const StretchRange& limits) const {
        return std::max(std::log(most) / std::log(limits.most), std::log(least) / std::log(limits.least));
    }
};

class Predecessors;

class Stretches {
  public:
    using Slots = std::bitset<surfel::blockCapacity>;

    /// What is known of a block that the stroke has changed.
    struct Tracked {
        surfel::BlockPtr then, now;        ///< the same slots
        surfel::BlockPtr origin;           ///< the same slots, where they come from
        std::vector<StretchRange> before;  ///< of each slot until `then`; empty: none
        std::vector<LocalSpacing> spacing; ///< of each slot, around its origin; empty: none yet
        Slots seen;                        ///< were resampled in this stroke
        Slots asked;                       ///< are to be resampled now
        Slots drawn;                       ///< because they were drawn apart, now or before
        StretchRange range;
        /// Of each slot, in all.
        std::vector<StretchRange> ranges() const;
    };

    /// After an edit of `before` that changes blocks. Returns the longest way that a surfel went.
    float note(const tree::SurfelTree& before, const tree::Edit& edit);
    /// Over all blocks.
    StretchRange range() const;
    /// Surfels in the blocks that are not within `limits`.
    std::size_t beyond(const StretchRange& limits) const;
    /// fn(tracked), in no particular order.
    template <class Fn>
    void forEach(const Fn& fn) const {
        for (const auto& [block, each] : m_tracked)
            fn(each);
    }
    /// Sets spacings where they are missing of the slots that wanted(tracked) has set. newMeasure() gives what is
    /// called by one thread as measure(origin, slots, out), for up to 16 slots of a block at once; it is called from
    /// many, and so is wanted.
    template <class Wanted, class NewMeasure>
    void measureWhere(const Wanted& wanted, const NewMeasure& newMeasure);
    /// Null for blocks that the stroke has not changed.
    const Tracked* find(const surfel::SurfelBlock& block) const;

    /// Asks for all that moved in blocks beyond the limits, and notes it as drawn apart where the upper one is passed;
    /// from now on they count as they are. (In one cluster of a thread that is drawn out all pairs may lie across it.)
    void ask(const StretchRange& limits);
    /// The same for the most strained of them, up to about `count` surfels, and for all that are not within `must`.
    void askMost(const tree::SurfelTree& now, const StretchRange& limits, const StretchRange& must, std::size_t count);
    /// Asks for those for which asks(tracked, slot, range) is true; beyond `drawn` they count as drawn apart.
    template <class Asks>
    void askWhere(const Asks& asks, float drawn);
    /// Asks for these slots of a block that is tracked, as drawn apart.
    void ask(const surfel::SurfelBlock& now, const Slots& slots);
    /// Asks for what moved within `reach(tracked, slot)` of a surfel that is asked for: a tear shows in pairs across it
    /// alone.
    template <class Reach>
    void askAround(const tree::SurfelTree& now, const Reach& reach);
    /// Those asked for that pass(tracked, slot), which are no longer asked for: in the order of blocks, and none of the
    /// rest once there are `count`.
    template <class Pass>
    tree::Selection take(const tree::SurfelTree& now, const Pass& pass,
                         std::size_t count = std::numeric_limits<std::size_t>::max());

    /// After a resampling of what was taken: what is known goes over to the blocks that came.
    void follow(const tree::SurfelTree& before, const tree::SurfelTree& after);
    void clear() { m_tracked.clear(); }

  private:
    static void askAll(Tracked& each, const StretchRange& limits);
    void track(Tracked each) { m_tracked.insert_or_assign(each.now.get(), std::move(each)); }
    Tracked followed(const Predecessors& before, const surfel::BlockPtr& block) const;

    std::unordered_map<const surfel::SurfelBlock*, Tracked> m_tracked; ///< by `now`
};

template <class Wanted, class NewMeasure>
void Stretches::measureWhere(const Wanted& wanted, const NewMeasure& newMeasure) {
    std::vector<Tracked*> all;
    for (auto& [block, each] : m_tracked)
        all.push_back(&each);
    base::parallelFor(all.size(), 1, [&](std::size_t i) {
        Tracked& each = *all[i];
        const Slots slots = wanted(each);
        if (slots.none())
            return;
        std::vector<int> missing;
        for (int slot = 0; slot < each.now->size(); ++slot)
            if (const auto s = static_cast<std::size_t>(slot);
                slots[s] && (each.spacing.empty() || !each.spacing[s].known))
                missing.push_back(slot);
        if (missing.empty())
            return;
        each.spacing.resize(static_cast<std::size_t>(each.now->size()));
        auto measure = newMeasure();
        std::array<LocalSpacing, surfel::clusterSize> found;
        for (std::size_t first = 0; first < missing.size(); first += found.size()) {
            const auto some = std::span(missing).subspan(first, std::min(found.size(), missing.size() - first));
            measure(*each.origin, some, std::span(found).first(some.size()));
            for (std::size_t k = 0; k < some.size(); ++k)
                each.spacing[static_cast<std::size_t>(some[k])] = found[k];
        }
    });
}

template <class Asks>
void Stretches::askWhere(const Asks& asks, float drawn) {
    for (auto& [block, each] : m_tracked) {
        const std::vector<StretchRange> ranges = each.ranges();
        for (std::size_t slot = 0; slot < ranges.size(); ++slot)
            if (asks(each, static_cast<int>(slot), ranges[slot])) {
                each.asked.set(slot);
                each.drawn.set(slot, each.drawn[slot] || ranges[slot].most > drawn);
            }
    }
}

template <class Reach>
void Stretches::askAround(const tree::SurfelTree& now, const Reach& reach) {
    std::unordered_map<const surfel::SurfelBlock*, Slots> more;
    for (const auto& [block, each] : m_tracked)
        for (int slot = 0; slot < block->size(); ++slot) {
            if (!each.asked[static_cast<std::size_t>(slot)])
                continue;
            const base::Vec3f p = block->position(slot);
            const float radius = reach(each, slot);
            now.forBlocksInBall(p, radius, [&](std::uint32_t, const surfel::SurfelBlock& near) {
                const auto found = m_tracked.find(&near);
                if (found == m_tracked.end())
                    return;
                for (int k = 0; k < near.size(); ++k)
                    if (distanceSq(near.position(k), p) < radius * radius &&
                        near.position(k) != found->second.origin->position(k))
                        more[&near].set(static_cast<std::size_t>(k)); // and drawn: a tear is one side's as the other's
            });
        }
    for (const auto& [block, slots] : more)
        m_tracked.at(block).asked |= slots;
}

template <class Pass>
tree::Selection Stretches::take(const tree::SurfelTree& now, const Pass& pass, std::size_t count) {
    tree::Selection out;
    std::size_t has = 0;
    now.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        if (has >= count)
            return;
        const auto found = m_tracked.find(&block);
        if (found == m_tracked.end() || found->second.asked.none())
            return;
        tree::SelectedBlock taken{number, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            taken.slots.set(static_cast<std::size_t>(slot),
                            found->second.asked[static_cast<std::size_t>(slot)] && pass(found->second, slot));
        found->second.asked &= ~taken.slots;
        if (taken.slots.any())
            out.push_back(taken), has += taken.slots.count();
    });
    return out;
}

} // namespace sculpt
