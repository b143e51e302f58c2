// Drift: what strokes before have drawn apart, each by too little to resample, and this one more.
#include "core/process/estimation/spacing.h"
#include "core/sculpt/own_block.h"
#include "core/sculpt/sampling.h"

#include <algorithm>
#include <numbers>
#include <unordered_map>

namespace sculpt {

/// At the end a surfel that a stroke has stretched by more than this counts with what strokes before have done.
constexpr float stretched = 1.02f;
/// The same where surfels lie by chance, for what is usual around them: supports then hold a fifth of what they are
/// made for, about eight. Between coarse and fine they are off by up to 1.7 from the beginning.
constexpr float driftByChance = 2.2f;
/// So many surfels tell what is usual among them.
constexpr std::size_t enoughToTell = 6;
/// Of bounds: they are computed in another order.
constexpr float rounding = 1e-4f;

/// A block that the stroke has stretched a little, with room beside some of its surfels.
struct Sampling::Candidate {
    const Stretches::Tracked* tracked = nullptr;
    std::vector<StretchRange> ranges;
    Stretches::Slots room;
    Stretches::Slots told; ///< of these: not drawn apart, unless they lie by chance
    Stretches::Slots low;  ///< cannot be far farther apart than their supports are made for

    void boundByBlock(const KeptSpacing& kept, float done);
    bool cannotDrift() const;
};

/// Is this a block of the version that the stroke began on?
static bool isOf(const tree::SurfelTree& first, const surfel::SurfelBlock& block) {
    bool out = false;
    first.forBlocksInBall(block.position(0), 0,
                          [&](std::uint32_t, const surfel::SurfelBlock& each) { out |= &each == &block; });
    return out;
}

/// Of most the block by itself tells what measuring would, since others around can only be nearer. Where the supports
/// are not alike the target is what is measured, and nothing is drawn apart but by a large stretch. Where they are, and
/// no two around lie by chance, the six nearest are measured. By chance the disc of the 14 nearest is: at least 7 of
/// them face alike, and at most two of these do not count.
void Sampling::Candidate::boundByBlock(const KeptSpacing& kept, float done) {
    const surfel::SurfelBlock& origin = *tracked->origin;
    if (!isOf(kept.first().tree(), origin))
        return;
    constexpr float leastHeld = 5;
    float madeFor[surfel::blockCapacity] = {}, most[surfel::blockCapacity] = {}, radiusSq[surfel::blockCapacity] = {};
    for (std::size_t s = 0; s < ranges.size(); ++s) {
        madeFor[s] = kept.madeFor(kept.supportOf(*tracked->now, static_cast<int>(s)));
        most[s] = driftByChance * kept.typical() * madeFor[s] / ranges[s].most * (1 - rounding);
        radiusSq[s] = most[s] * most[s] * (leastHeld / std::numbers::pi_v<float> * (1 - rounding));
    }
    OwnBlock seen;
    lookWithin(origin, radiusSq, seen);
    for (std::size_t s = 0; s < ranges.size(); ++s) {
        const float ring = seen.ring[s] * (1 + rounding);
        low.set(s, ring <= most[s] && seen.within[s] >= static_cast<float>(KeptSpacing::Search::asked));
        told.set(s, room[s] && ranges[s].most <= done * (1 - rounding) && ranges[s].most * ring <= done * madeFor[s]);
    }
}

/// Have more than half of what is stretched no part in a drift, so that the median has none?
bool Sampling::Candidate::cannotDrift() const {
    std::size_t all = 0, without = 0;
    for (std::size_t s = 0; s < ranges.size(); ++s)
        if (ranges[s].most > stretched)
            ++all, without += low[s] ? 1 : 0;
    return all < enoughToTell || without > all / 2;
}

/// Of those in a block that this stroke has stretched a little: are they on the whole far farther apart than their
/// supports are made for? Where surfels lie by chance each alone may be, and always has been, and where they become
/// finer by and by the supports are off by some part everywhere.
bool Sampling::drifted(const Stretches::Tracked& each, const std::vector<StretchRange>& ranges) const {
    std::vector<float> apart;
    for (std::size_t slot = 0; slot < ranges.size(); ++slot) {
        const int s = static_cast<int>(slot);
        if (ranges[slot].most > stretched)
            apart.push_back(ranges[slot].most * measuredOf(each, s).value /
                            (m_kept.typical() * m_kept.madeFor(m_kept.supportOf(*each.now, s))));
    }
    return apart.size() >= enoughToTell && process::summarise(std::move(apart)).median > driftByChance;
}

/// Those of the blocks that it has stretched so, in tree order.
std::vector<Sampling::Candidate> Sampling::driftCandidates(const surface::Surface& surface) const {
    const tree::SurfelTree& tree = surface.tree();
    tree::Selection more;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const Stretches::Tracked* known = m_stretches.find(block);
        if (known && known->range.most > stretched)
            more.push_back({number, {}});
    });
    std::vector<Candidate> all(more.size());
    base::parallelFor(more.size(), 4, [&](std::size_t i) {
        all[i].tracked = m_stretches.find(*tree.block(more[i].block));
        all[i].ranges = all[i].tracked->ranges();
        for (std::size_t slot = 0; slot < all[i].ranges.size(); ++slot)
            more[i].slots.set(slot, all[i].ranges[slot].most > stretched && !all[i].tracked->asked[slot]);
    });
    std::size_t kept = 0, at = 0;
    const tree::Selection room = process::withRoom(surface, more, [&](const surfel::SurfelBlock& block) {
        float least = block.maxSupport();
        for (int slot = 0; slot < block.size(); ++slot)
            least = std::min(least, block.support(slot));
        return m_kept.madeFor(least);
    });
    for (const tree::SelectedBlock& each : room) {
        while (more[at].block != each.block)
            ++at;
        all[at].room = each.slots;
        std::swap(all[kept++], all[at]);
    }
    all.resize(kept);
    base::parallelFor(kept, 4, [&](std::size_t i) { all[i].boundByBlock(m_kept, doneBeyond.most); });
    return all;
}

/// Those that strokes before have drawn apart and this one more, so that there is room now. Where surfels lie by
/// chance, all of a block have to tell.
void Sampling::askForDrift(const surface::Surface& surface) {
    const std::vector<Candidate> all = driftCandidates(surface);
    std::unordered_map<const Stretches::Tracked*, Stretches::Slots> wanted;
    const auto measure = [&] {
        measureTracked([&](const Stretches::Tracked& each) {
            const auto found = wanted.find(&each);
            return found == wanted.end() ? Stretches::Slots() : found->second;
        });
    };
    for (const Candidate& each : all)
        wanted[each.tracked] = each.room & ~each.told;
    measure();
    wanted.clear();
    for (const Candidate& each : all)
        if (!each.cannotDrift())
            wanted[each.tracked].set();
    measure();
    for (const Candidate& each : all) {
        const bool drifts = !each.cannotDrift() && drifted(*each.tracked, each.ranges);
        Stretches::Slots drawn = drifts ? each.room : each.room & ~each.told;
        for (std::size_t slot = 0; slot < each.ranges.size(); ++slot)
            if (drawn[slot]) {
                const int s = static_cast<int>(slot);
                const LocalSpacing at = measuredOf(*each.tracked, s);
                drawn.set(slot, each.ranges[slot].most * at.value > doneBeyond.most * targetOf(*each.tracked, s) &&
                                    (at.even || drifts));
            }
        m_stretches.ask(*each.tracked->now, drawn);
    }
}

} // namespace sculpt
