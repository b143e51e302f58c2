// Drift: what strokes before have drawn apart, each by too little to resample, and this one more.
#include "core/process/estimation/spacing.h"
#include "core/sculpt/sampling.h"

#include <algorithm>
#include <set>

namespace sculpt {

/// At the end a surfel that a stroke has stretched by more than this counts with what strokes before have done.
constexpr float stretched = 1.02f;
/// The same where surfels lie by chance, for what is usual around them: supports then hold a fifth of what they are
/// made for, about eight. Between coarse and fine they are off by up to 1.7 from the beginning.
constexpr float driftByChance = 2.2f;
/// So many surfels tell what is usual among them.
constexpr std::size_t enoughToTell = 6;

/// Of those in a block that this stroke has stretched a little: are they on the whole far farther apart than their
/// supports are made for? Where surfels lie by chance each alone may be, and always has been, and where they become
/// finer by and by the supports are off by some part everywhere.
bool Sampling::drifted(const Stretches::Tracked& each) const {
    const std::vector<StretchRange> ranges = each.ranges();
    std::vector<float> apart;
    for (std::size_t slot = 0; slot < ranges.size(); ++slot) {
        const int s = static_cast<int>(slot);
        if (ranges[slot].most > stretched)
            apart.push_back(ranges[slot].most * measuredOf(each, s).value /
                            (m_kept.typical() * m_kept.madeFor(m_kept.supportOf(*each.now, s))));
    }
    return apart.size() >= enoughToTell && process::summarise(std::move(apart)).median > driftByChance;
}

/// Those that strokes before have drawn apart and this one more, so that there is room now.
void Sampling::askForDrift(const surface::Surface& surface) {
    tree::Selection more;
    surface.tree().forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const Stretches::Tracked* known = m_stretches.find(block);
        if (!known || known->range.most <= stretched)
            return;
        tree::SelectedBlock some{number, {}};
        const std::vector<StretchRange> ranges = known->ranges();
        for (std::size_t slot = 0; slot < ranges.size(); ++slot)
            some.slots.set(slot, ranges[slot].most > stretched && !known->asked[slot]);
        if (some.slots.any())
            more.push_back(some);
    });
    more = process::withRoom(surface, more, [&](const surfel::SurfelBlock& block) {
        float least = block.maxSupport();
        for (int slot = 0; slot < block.size(); ++slot)
            least = std::min(least, block.support(slot));
        return m_kept.madeFor(least);
    });
    std::unordered_map<const surfel::SurfelBlock*, Stretches::Slots> room;
    for (const tree::SelectedBlock& each : more)
        room[surface.tree().block(each.block).get()] = each.slots;
    const auto hasRoom = [&](const Stretches::Tracked& each, int slot) {
        const auto found = room.find(each.now.get());
        return found != room.end() && found->second[static_cast<std::size_t>(slot)];
    };
    const auto isDrawn = [&](const Stretches::Tracked& each, int slot, const StretchRange& range) {
        return hasRoom(each, slot) &&
               range.most * measuredOf(each, slot).value > doneBeyond.most * targetOf(each, slot);
    };
    measureTracked(hasRoom);
    std::set<const Stretches::Tracked*> byChance; // asked about where all of them have to tell
    m_stretches.forEach([&](const Stretches::Tracked& each) {
        if (!room.contains(each.now.get()))
            return;
        const std::vector<StretchRange> ranges = each.ranges();
        for (std::size_t slot = 0; slot < ranges.size(); ++slot)
            if (const int s = static_cast<int>(slot); isDrawn(each, s, ranges[slot]) && !measuredOf(each, s).even)
                byChance.insert(&each);
    });
    measureTracked([&](const Stretches::Tracked& each, int) { return byChance.contains(&each); });
    std::erase_if(byChance, [&](const Stretches::Tracked* each) { return drifted(*each); });
    m_stretches.askWhere(
        [&](const Stretches::Tracked& each, int slot, const StretchRange& range) {
            return isDrawn(each, slot, range) && (measuredOf(each, slot).even || !byChance.contains(&each));
        },
        stretched);
}

} // namespace sculpt
