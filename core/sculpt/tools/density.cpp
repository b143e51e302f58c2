#include "core/sculpt/tools/density.h"

#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/tools/inside.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// A dab of full strength changes the spacing by at most this: filling looks for room one spacing away, not ten.
constexpr float largestChange = 1.5f;
/// How fast supports may change over distance (sculpt/README 6.4).
constexpr float grading = 0.5f;
/// What stays inside the rim, in spacings.
constexpr float margin = 1.5f;

constexpr ToolParameter parameters[] = {
    {"factor", "Factor", "", "Spacing that the stroke leaves, as a fraction of what it found.", 0.6, 0.25, 1.0},
};

namespace {

/// What the dab aims at.
struct Aim {
    base::Vec3f centre;
    float radius;
    float from, to; ///< supports: where the stroke began, and after this dab in the middle

    /// The graded support of a surfel that had `present`; it goes towards the aim or stays.
    float support(const base::Vec3f& p, float present) const {
        const float room = grading * std::max(0.0f, radius - distance(p, centre));
        return to < from ? std::min(present, std::max(to, from - room)) : std::max(present, std::min(to, from + room));
    }
};

/// Gives all that is under the brush and stays its graded support, on top of what `edit` does.
tree::Edit graded(const tree::SurfelTree& tree, const Brush& brush, const Aim& aim, tree::Edit edit) {
    tree::Edit out;
    out.inserted = std::move(edit.inserted);
    for (surfel::Surfel& s : out.inserted.items)
        s.support = aim.support(s.position, aim.from);
    std::vector<BrushBlock> blocks = blocksUnder(tree, brush.centre, brush.radius);
    const int shape = surfel::shapeChannel(*tree.layout());
    out.blocks.resize(blocks.size());
    base::parallelFor(blocks.size(), 8, [&](std::size_t b) {
        tree::BlockEdit& change = out.blocks[b];
        change.block = blocks[b].number;
        const auto found = std::lower_bound(edit.blocks.begin(), edit.blocks.end(), change.block,
                                            [](const tree::BlockEdit& e, std::uint32_t n) { return e.block < n; });
        if (found != edit.blocks.end() && found->block == change.block)
            change = *found;
        const surfel::SurfelBlock& now = change.changed ? *change.changed : *blocks[b].block;
        surfel::MutableBlockPtr changed;
        alignas(64) float weight[lanes];
        for (int slot = 0; slot < now.size(); ++slot) {
            if (slot % surfel::clusterSize == 0)
                brush.weigh(blocks[b], slot / surfel::clusterSize, weight);
            const float present = blocks[b].block->support(slot);
            const float support =
                weight[slot % surfel::clusterSize] > 0 ? aim.support(now.position(slot), present) : present;
            if (support == now.support(slot))
                continue;
            if (!changed)
                changed = now.clone();
            surfel::setBall(*changed, slot, shape, support);
        }
        if (changed)
            changed->seal(), change.changed = changed;
    });
    std::erase_if(out.blocks, [](const tree::BlockEdit& e) { return !e.changed && e.removed.none(); });
    return out;
}

} // namespace

static tree::Edit density(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const surface::SurfaceDefinition& definition = version.definition();
    const float first = process::localSpacing(dab.first ? *dab.first : version, dab.centre);
    const float present = process::localSpacing(version, dab.centre);
    if (dab.strength == 0 || !(first > 0) || !(present > 0))
        return {};
    const float factor = dab.parameter("factor"), perSpacing = process::supportOf(definition, 1.0f);
    const bool oneSupport = definition.support > 0;
    float goal = dab.strength < 0 ? first / factor : first * factor;
    if (!oneSupport)
        goal = std::min(goal, first + grading * 0.5f * dab.radius / perSpacing);
    const float change = std::pow(largestChange, std::abs(dab.strength));
    process::ResampleOptions options;
    options.spacing = std::clamp(goal, present / change, present * change);
    options.support = process::supportOf(definition, options.spacing);
    options.relaxAll = true;
    const Aim aim{dab.centre, dab.radius, process::supportOf(definition, first), options.support};
    // Coarse sampling begins only where the supports are wide enough for it.
    const float ramp = oneSupport ? 0.0f : std::max(0.0f, aim.to - aim.from) / grading;
    const float within = dab.radius - std::max(ramp, margin * std::max(present, options.spacing));
    tree::Edit edit = process::resample(version, inside(version.tree(), brush, within), options);
    return oneSupport ? edit : graded(version.tree(), brush, aim, std::move(edit));
}

const ToolRow densityTool{"density",
                          "Density",
                          "icons/tool-density.svg",
                          "",
                          "Makes the sampling finer where it is too coarse for detail; inverted, coarser.",
                          Motion::Along,
                          1.0,
                          parameters,
                          density,
                          Writes::Count};

} // namespace sculpt
