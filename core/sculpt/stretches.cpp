#include "core/sculpt/stretches.h"

#include "core/base/clones.h"
#include "core/base/parallel.h"
#include "core/base/parallel_sort.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sculpt {

/// Where surfels of a version come from on the one before: the same place, mostly, else the nearest.
class Predecessors {
  public:
    struct Found {
        const surfel::SurfelBlock* block = nullptr; ///< null: there is none
        int slot = 0;
        bool same = false; ///< has not moved
    };

    /// `gone`: blocks of `before` that the later version has not. Both outlive it.
    Predecessors(const tree::SurfelTree& before, std::span<const surfel::BlockPtr> gone);
    Found of(const base::Vec3f& x, std::vector<tree::Neighbour>& near) const;

  private:
    struct Place {
        base::Vec3f position;
        std::uint32_t order;
        const surfel::SurfelBlock* block;
        int slot;
    };
    const tree::SurfelTree& m_before;
    std::vector<Place> m_places; ///< by coordinates
};

using surfel::clusterSize;
using surfel::SurfelBlock;

/// Pairs much closer than the others of their cluster say little about the stretch: part of the mean square distance.
constexpr float damping = 1.0f / 32;

[[gnu::always_inline]] static inline float largest(float* value, int count) {
    for (; count > 1; count /= 2)
        for (int i = 0; i < count / 2; ++i)
            value[i] = surfel::larger(value[i], value[i + count / 2]);
    return value[0];
}

constexpr int steps = 2, pairs = steps * clusterSize;

/// Of pairs (i, i + 1), then (i, i + 2), squared: distance, and the part along the surface; slots past the end are
/// pairs with themselves.
struct Pairs {
    float whole[pairs] = {}, along[pairs] = {};
};

[[gnu::always_inline]] static inline void pairUp(const float* p, Pairs& out) {
    constexpr int c = clusterSize;
    const float *x = p, *y = p + c, *z = p + 2 * c, *nx = p + surfel::NormalX * c, *ny = nx + c, *nz = ny + c;
    for (int step = 1; step <= steps; ++step) {
        float *whole = out.whole + (step - 1) * c, *along = out.along + (step - 1) * c;
        for (int i = 0; i < c - step; ++i) {
            const float dx = x[i + step] - x[i], dy = y[i + step] - y[i], dz = z[i + step] - z[i];
            const float up = dx * nx[i] + dy * ny[i] + dz * nz[i];
            whole[i] = dx * dx + dy * dy + dz * dz;
            along[i] = surfel::larger(whole[i] - up * up, 0.0f);
        }
    }
}

/// Squared ratios of the pairs, and the inverses of those along the surface. Where a pair stands steeper than 45
/// degrees those are 1.
[[gnu::always_inline]] static inline void pairRatios(const float* then, const float* now, float* out, float* in) {
    Pairs was, is;
    pairUp(then, was);
    pairUp(now, is);
    float sum = 0;
    for (int i = 0; i < pairs; ++i)
        sum += was.whole[i];
    const float damp = surfel::larger(sum * (damping / pairs), 1e-30f);
    for (int i = 0; i < pairs; ++i) {
        const bool flat = 2 * was.along[i] >= was.whole[i] && 2 * is.along[i] >= is.whole[i];
        const float nearer = (was.along[i] + damp) / (is.along[i] + damp);
        out[i] = (is.whole[i] + damp) / (was.whole[i] + damp), in[i] = flat ? nearer : 1.0f;
    }
}

POINTCLAY_CLONES
static void clusterRange(const float* then, const float* now, float& least, float& most) {
    float out[pairs], in[pairs];
    pairRatios(then, now, out, in);
    most = surfel::larger(most, largest(out, pairs));
    least = surfel::larger(least, largest(in, pairs));
}

static StretchRange rangeOf(const SurfelBlock& then, const SurfelBlock& now) {
    float least = 1, most = 1;
    for (int cluster = 0; cluster < now.clusterCount(); ++cluster)
        clusterRange(then.channel(cluster, surfel::X), now.channel(cluster, surfel::X), least, most);
    return {1 / std::sqrt(least), std::sqrt(most)};
}

std::vector<StretchRange> Stretches::Tracked::ranges() const {
    std::vector<StretchRange> all(static_cast<std::size_t>(now->size()));
    for (int cluster = 0; cluster < now->clusterCount(); ++cluster) {
        float least = 1, most = 1;
        clusterRange(then->channel(cluster, surfel::X), now->channel(cluster, surfel::X), least, most);
        const StretchRange ofAll{1 / std::sqrt(least), std::sqrt(most)};
        const int end = std::min(now->size(), (cluster + 1) * clusterSize);
        for (int slot = cluster * clusterSize; slot < end; ++slot)
            if (now->position(slot) != origin->position(slot))
                all[static_cast<std::size_t>(slot)] = ofAll;
    }
    for (std::size_t i = 0; i < before.size(); ++i)
        all[i].least *= before[i].least, all[i].most *= before[i].most;
    return all;
}

/// Squared longest way of a slot.
POINTCLAY_CLONES
static float longestWay(const SurfelBlock& from, const SurfelBlock& to) {
    float most[clusterSize] = {};
    for (int cluster = 0; cluster < from.clusterCount(); ++cluster) {
        const float *p = from.channel(cluster, surfel::X), *q = to.channel(cluster, surfel::X);
        for (int i = 0; i < clusterSize; ++i) {
            const float dx = q[i] - p[i], dy = q[clusterSize + i] - p[clusterSize + i],
                        dz = q[2 * clusterSize + i] - p[2 * clusterSize + i];
            most[i] = surfel::larger(most[i], dx * dx + dy * dy + dz * dz);
        }
    }
    return largest(most, clusterSize);
}

/// Of the block: that of its pairs, or where there was more before, of its slots.
static StretchRange measured(const Stretches::Tracked& each) {
    StretchRange out;
    if (each.before.empty())
        return rangeOf(*each.then, *each.now);
    for (const StretchRange& slot : each.ranges())
        out.unite(slot);
    return out;
}

float Stretches::note(const tree::SurfelTree& before, const tree::Edit& edit) {
    std::vector<Tracked> tracked(edit.blocks.size());
    std::vector<const SurfelBlock*> was(edit.blocks.size());
    std::vector<float> ways(edit.blocks.size(), 0.0f);
    base::parallelFor(tracked.size(), 16, [&](std::size_t i) {
        const surfel::BlockPtr now = edit.blocks[i].changed, old = before.block(edit.blocks[i].block);
        if (!now)
            return;
        if (const auto known = m_tracked.find(old.get()); known != m_tracked.end())
            tracked[i] = known->second;
        else
            tracked[i].then = tracked[i].origin = old;
        was[i] = old.get();
        ways[i] = longestWay(*old, *now);
        tracked[i].now = now;
        tracked[i].range = measured(tracked[i]);
    });
    for (std::size_t i = 0; i < tracked.size(); ++i)
        if (tracked[i].now) {
            m_tracked.erase(was[i]);
            track(std::move(tracked[i]));
        }
    return ways.empty() ? 0.0f : std::sqrt(*std::max_element(ways.begin(), ways.end()));
}

StretchRange Stretches::range() const {
    StretchRange out;
    for (const auto& [block, each] : m_tracked)
        out.unite(each.range);
    return out;
}

std::size_t Stretches::beyond(const StretchRange& limits) const {
    std::size_t out = 0;
    for (const auto& [block, each] : m_tracked)
        out += each.range.within(limits) ? 0 : static_cast<std::size_t>(each.now->size());
    return out;
}

const Stretches::Tracked* Stretches::find(const SurfelBlock& block) const {
    const auto found = m_tracked.find(&block);
    return found == m_tracked.end() ? nullptr : &found->second;
}

/// The surfels that have moved since the stroke began.
static Stretches::Slots moved(const Stretches::Tracked& each) {
    Stretches::Slots out;
    for (int slot = 0; slot < each.now->size(); ++slot)
        out.set(static_cast<std::size_t>(slot), each.now->position(slot) != each.origin->position(slot));
    return out;
}

/// Asks for all of a block that moved; from now on it counts as it is.
void Stretches::askAll(Tracked& each, const StretchRange& limits) {
    const Slots all = moved(each);
    each.asked |= all, each.seen |= all;
    if (each.range.most > limits.most)
        each.drawn |= all;
    each.then = each.now;
    each.before.clear();
    each.range = {};
}

void Stretches::ask(const StretchRange& limits) {
    for (auto& [block, each] : m_tracked)
        if (!each.range.within(limits))
            askAll(each, limits);
}

void Stretches::ask(const SurfelBlock& now, const Slots& slots) {
    Tracked& each = m_tracked.at(&now);
    each.asked |= slots, each.drawn |= slots;
}

void Stretches::askMost(const tree::SurfelTree& now, const StretchRange& limits, const StretchRange& must,
                        std::size_t count) {
    struct Candidate {
        Tracked* tracked;
        float strain;
    };
    std::vector<Candidate> all; // in the order of blocks
    now.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        const auto found = m_tracked.find(&block);
        if (found != m_tracked.end() && !found->second.range.within(limits))
            all.push_back({&found->second, found->second.range.strain(must)});
    });
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.strain > b.strain; });
    std::size_t has = 0;
    for (const Candidate& each : all) {
        if (has >= count && each.strain <= 1)
            break;
        has += static_cast<std::size_t>(each.tracked->now->size());
        askAll(*each.tracked, limits);
    }
}

Predecessors::Predecessors(const tree::SurfelTree& before, std::span<const surfel::BlockPtr> gone) : m_before(before) {
    for (const surfel::BlockPtr& block : gone)
        for (int slot = 0; slot < block->size(); ++slot)
            m_places.push_back({block->position(slot), static_cast<std::uint32_t>(m_places.size()), block.get(), slot});
    base::parallelSort(m_places, [](const Place& a, const Place& b) {
        return std::tie(a.position.x, a.position.y, a.position.z, a.order) <
               std::tie(b.position.x, b.position.y, b.position.z, b.order);
    });
}

Predecessors::Found Predecessors::of(const base::Vec3f& x, std::vector<tree::Neighbour>& near) const {
    const auto at = std::lower_bound(m_places.begin(), m_places.end(), x, [](const Place& a, const base::Vec3f& p) {
        return std::tie(a.position.x, a.position.y, a.position.z) < std::tie(p.x, p.y, p.z);
    });
    if (at != m_places.end() && at->position == x)
        return {at->block, at->slot, true};
    m_before.nearest(x, 1, near);
    return near.empty() ? Found{} : Found{near[0].block, near[0].slot, near[0].distanceSq == 0};
}

Stretches::Tracked Stretches::followed(const Predecessors& before, const surfel::BlockPtr& block) const {
    const surfel::MutableBlockPtr origin = block->clone();
    Tracked out;
    out.then = out.now = block;
    out.before.resize(static_cast<std::size_t>(block->size()));
    out.spacing.resize(static_cast<std::size_t>(block->size()));
    std::vector<tree::Neighbour> near;
    std::unordered_map<const Tracked*, std::vector<StretchRange>> ranges;
    for (int slot = 0; slot < block->size(); ++slot) {
        const auto s = static_cast<std::size_t>(slot);
        const Predecessors::Found found = before.of(block->position(slot), near);
        if (!found.block)
            continue;
        const auto from = static_cast<std::size_t>(found.slot);
        const Tracked* const known = find(*found.block);
        out.seen.set(s, !found.same || (known && known->seen[from]));
        out.drawn.set(s, known && known->drawn[from]);
        origin->setPosition(slot, (known ? *known->origin : *found.block).position(found.slot));
        if (known && !known->spacing.empty())
            out.spacing[s] = known->spacing[from];
        if (!known || !found.same)
            continue;
        out.asked.set(s, known->asked[from]);
        auto& of = ranges[known];
        if (of.empty())
            of = known->ranges();
        out.before[s] = of[from];
    }
    origin->seal();
    out.origin = origin;
    out.range = measured(out);
    return out;
}

void Stretches::follow(const tree::SurfelTree& before, const tree::SurfelTree& after) {
    const tree::Diff changes = diff(before, after);
    const Predecessors predecessors(before, changes.removed);
    std::vector<Tracked> came(changes.added.size());
    base::parallelFor(came.size(), 1, [&](std::size_t i) { came[i] = followed(predecessors, changes.added[i]); });
    for (const surfel::BlockPtr& gone : changes.removed)
        m_tracked.erase(gone.get());
    for (Tracked& each : came)
        track(std::move(each));
}

} // namespace sculpt
