#include "core/sculpt/stretches.h"

#include "core/base/clones.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

using surfel::clusterSize;
using surfel::SurfelBlock;

/// Pairs much closer than this part of the spacing say little about the stretch.
constexpr float damping = 0.25f;

[[gnu::always_inline]] static inline float largest(float* value, int count) {
    for (; count > 1; count /= 2)
        for (int i = 0; i < count / 2; ++i)
            value[i] = surfel::larger(value[i], value[i + count / 2]);
    return value[0];
}

/// Squared distances of slots i and i + step, damped; the last `step` are those of a slot and itself.
[[gnu::always_inline]] static inline void distances(const float* p, int step, float damp, float* out) {
    const float *x = p, *y = p + clusterSize, *z = p + 2 * clusterSize;
    for (int i = 0; i < clusterSize - step; ++i) {
        const float dx = x[i + step] - x[i], dy = y[i + step] - y[i], dz = z[i + step] - z[i];
        out[i] = dx * dx + dy * dy + dz * dz + damp;
    }
    for (int i = clusterSize - step; i < clusterSize; ++i)
        out[i] = damp;
}

/// Squared ratios of a cluster; slots past the end lie still.
POINTCLAY_CLONES
static void ratios(const float* then, const float* now, float damp, float& least, float& most) {
    float out[2 * clusterSize], in[2 * clusterSize];
    for (int step = 1; step <= 2; ++step) {
        float was[clusterSize], is[clusterSize];
        distances(then, step, damp, was);
        distances(now, step, damp, is);
        for (int i = 0; i < clusterSize; ++i)
            out[(step - 1) * clusterSize + i] = is[i] / was[i], in[(step - 1) * clusterSize + i] = was[i] / is[i];
    }
    most = surfel::larger(most, largest(out, 2 * clusterSize));
    least = surfel::larger(least, largest(in, 2 * clusterSize));
}

static StretchRange rangeOf(const SurfelBlock& then, const SurfelBlock& now, float spacing) {
    const float damp = damping * damping * spacing * spacing;
    float least = 1, most = 1;
    for (int cluster = 0; cluster < now.clusterCount(); ++cluster)
        ratios(then.channel(cluster, surfel::X), now.channel(cluster, surfel::X), damp, least, most);
    return {1 / std::sqrt(least), std::sqrt(most)};
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

float Stretches::note(const tree::SurfelTree& before, const tree::Edit& edit, float spacing) {
    std::vector<Tracked> tracked(edit.blocks.size());
    std::vector<const SurfelBlock*> was(edit.blocks.size());
    std::vector<float> ways(edit.blocks.size(), 0.0f);
    base::parallelFor(tracked.size(), 16, [&](std::size_t i) {
        const surfel::BlockPtr now = edit.blocks[i].changed, old = before.block(edit.blocks[i].block);
        if (!now)
            return;
        const auto known = m_tracked.find(old.get());
        const surfel::BlockPtr then = known == m_tracked.end() ? old : known->second.then;
        was[i] = old.get();
        ways[i] = longestWay(*old, *now);
        tracked[i] = {then, now, rangeOf(*then, *now, spacing)};
    });
    for (std::size_t i = 0; i < tracked.size(); ++i)
        if (tracked[i].now) {
            m_tracked.erase(was[i]);
            m_tracked.emplace(tracked[i].now.get(), std::move(tracked[i]));
        }
    return ways.empty() ? 0.0f : std::sqrt(*std::max_element(ways.begin(), ways.end()));
}

StretchRange Stretches::range() const {
    StretchRange out;
    for (const auto& [block, each] : m_tracked)
        out.unite(each.range);
    return out;
}

/// The slots that lie elsewhere than they did.
static std::bitset<surfel::blockCapacity> moved(const SurfelBlock& then, const SurfelBlock& now) {
    std::bitset<surfel::blockCapacity> out;
    for (int slot = 0; slot < now.size(); ++slot)
        out.set(static_cast<std::size_t>(slot), then.position(slot) != now.position(slot));
    return out;
}

tree::Selection Stretches::take(const tree::SurfelTree& now, const StretchRange& limits) {
    tree::Selection out;
    for (auto at = m_tracked.begin(); at != m_tracked.end();) {
        const Tracked& each = at->second;
        bool there = false;
        std::uint32_t number = 0;
        now.forBlocksInBall(each.now->position(0), 0.001f * each.now->maxSupport(),
                            [&](std::uint32_t n, const SurfelBlock& block) {
                                if (&block == each.now.get())
                                    there = true, number = n;
                            });
        const bool beyond = !each.range.within(limits);
        if (there && beyond)
            if (const auto slots = moved(*each.then, *each.now); slots.any())
                out.push_back({number, slots});
        at = there && !beyond ? std::next(at) : m_tracked.erase(at);
    }
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
    return out;
}

} // namespace sculpt
