#include "core/sculpt/stroke/stroke_accumulate.h"

#include "core/base/parallel.h"
#include "core/surfel/shape.h"

#include <bit>
#include <cmath>
#include <cstdlib>

namespace sculpt {

using surfel::SurfelBlock;

/// Position, normal and footprint with its shape go together. Where neither dab moves the surfel, the last to turn it
/// counts.
static void takePlace(SurfelBlock& out, const SurfelBlock& first, const SurfelBlock& dab, int shape, int slot,
                      bool& changed) {
    const base::Vec3f start = first.position(slot);
    const float far = distanceSq(dab.position(slot), start), farthestYet = distanceSq(out.position(slot), start);
    const bool turns = far == 0 && farthestYet == 0 && dab.normal(slot) != first.normal(slot);
    if (!(far > farthestYet) && !turns)
        return;
    const int cluster = slot / surfel::clusterSize, lane = slot % surfel::clusterSize;
    out.setPosition(slot, dab.position(slot));
    out.setNormal(slot, dab.normal(slot));
    out.channel(cluster, surfel::Support)[lane] = dab.channel(cluster, surfel::Support)[lane];
    if (shape > 0)
        surfel::setShape(out, slot, shape, surfel::shapeOf(dab, slot, shape));
    changed = true;
}

/// How far a word has been taken. Of further attributes, whose types differ, the last to change one counts.
static float wordDistance(int channel, std::uint32_t a, std::uint32_t b) {
    if (channel == surfel::Mask)
        return std::abs(std::bit_cast<float>(a) - std::bit_cast<float>(b));
    int sum = channel == surfel::ColourWord ? 0 : 1;
    if (channel == surfel::ColourWord)
        for (int shift = 0; shift < 32; shift += 8)
            sum += std::abs(int(a >> shift & 255) - int(b >> shift & 255));
    return static_cast<float>(sum);
}

static void takeWord(SurfelBlock& out, const SurfelBlock& first, const SurfelBlock& dab, int channel, int slot,
                     bool& changed) {
    const int cluster = slot / surfel::clusterSize, lane = slot % surfel::clusterSize;
    const std::uint32_t start = first.words(cluster, channel)[lane], to = dab.words(cluster, channel)[lane];
    std::uint32_t& now = out.words(cluster, channel)[lane];
    const bool farther = now == start || channel >= surfel::Extra ||
                         wordDistance(channel, to, start) > wordDistance(channel, now, start);
    if (to == start || to == now || !farther)
        return;
    now = to;
    changed = true;
}

static surfel::BlockPtr farthestOf(const SurfelBlock& first, const SurfelBlock& now, const SurfelBlock& dab,
                                   int shape) {
    surfel::MutableBlockPtr out = now.clone();
    bool changed = false;
    const int channels = surfel::Extra + static_cast<int>(first.extraWords());
    for (int slot = 0; slot < first.size(); ++slot) {
        takePlace(*out, first, dab, shape, slot, changed);
        for (int channel = surfel::ColourWord; channel < channels; ++channel)
            if (shape == 0 || channel < shape || channel > shape + 2)
                takeWord(*out, first, dab, channel, slot, changed);
    }
    if (!changed)
        return {};
    out->seal();
    return out;
}

tree::Edit farthest(const tree::SurfelTree& start, const tree::SurfelTree& now, const tree::Edit& edit) {
    std::vector<surfel::BlockPtr> changed(edit.blocks.size());
    const int shape = surfel::shapeChannel(*start.layout());
    base::parallelFor(changed.size(), 8, [&](std::size_t i) {
        const std::uint32_t number = edit.blocks[i].block;
        changed[i] = farthestOf(*start.block(number), *now.block(number), *edit.blocks[i].changed, shape);
    });
    tree::Edit out;
    out.layout = edit.layout;
    for (std::size_t i = 0; i < changed.size(); ++i)
        if (changed[i])
            out.blocks.push_back({edit.blocks[i].block, std::move(changed[i]), {}});
    return out;
}

} // namespace sculpt
