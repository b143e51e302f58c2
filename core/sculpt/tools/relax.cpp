#include "core/sculpt/tools/relax.h"

#include "core/process/resampling/resample.h"
#include "core/sculpt/tools/area_spacing.h"
#include "core/sculpt/tools/inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sculpt {

/// Sweeps of a dab of full strength.
constexpr float sweeps = 5;
/// What stays inside the rim, in spacings.
constexpr float margin = 1.5f;
/// Supports under the brush that differ by no more are made for one spacing.
constexpr float alike = 1.25f;

static bool oneSpacing(const tree::SurfelTree& tree, const tree::Selection& under) {
    float least = std::numeric_limits<float>::infinity(), most = 0;
    for (const tree::SelectedBlock& each : under) {
        const surfel::BlockPtr block = tree.block(each.block);
        for (int slot = 0; slot < block->size(); ++slot)
            if (each.slots[static_cast<std::size_t>(slot)])
                least = std::min(least, block->support(slot)), most = std::max(most, block->support(slot));
    }
    return most <= alike * least;
}

/// What the stroke has measured around the surfels that the last dab looked at: most have not moved since.
struct RelaxMemory : ToolMemory {
    AreaSpacing found;
    RelaxMemory(const surface::Surface& first, float spacing) : found(first, spacing) {}
};

/// The largest target under the brush. All around it is measured then.
static float measureUnder(const tree::SurfelTree& tree, const tree::Selection& under, const Dab& dab, float spacing,
                          AreaSpacing& found) {
    std::vector<surfel::BlockPtr> blocks;
    for (const tree::SelectedBlock& each : under)
        blocks.push_back(tree.block(each.block));
    found.measure(blocks);
    for (std::size_t i = 0; i < under.size(); ++i)
        for (int slot = 0; slot < blocks[i]->size(); ++slot)
            if (under[i].slots[static_cast<std::size_t>(slot)])
                spacing = std::max(spacing, found.at(*blocks[i], slot));
    blocks = blocksAround(tree, dab.centre, dab.radius + inTheWay * spacing);
    found.keepOnly(blocks);
    found.measure(blocks);
    return spacing;
}

static tree::Edit relax(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    process::ResampleOptions options;
    options.spacing = process::localSpacing(version, dab.centre);
    options.sweeps = std::max(1, static_cast<int>(std::lround(sweeps * std::abs(dab.strength))));
    options.relaxAll = true;
    if (dab.strength == 0 || !(options.spacing > 0))
        return {};
    const tree::Selection under = inside(version.tree(), brush, dab.radius - margin * options.spacing);
    if (version.definition().support > 0 || oneSpacing(version.tree(), under))
        return process::resample(version, under, options);
    // Nothing has left its surface: what is measured on the first version holds here.
    std::unique_ptr<ToolMemory> once;
    AreaSpacing& found = memoryOf<RelaxMemory>(dab, once, dab.first ? *dab.first : version, options.spacing).found;
    options.spacing = measureUnder(version.tree(), under, dab, options.spacing, found);
    options.targetOf = [&](const surfel::SurfelBlock& block, int slot) { return found.at(block, slot); };
    return process::resample(version, under, options);
}

const ToolRow relaxTool{"relax",
                        "Relax",
                        "icons/tool-relax.svg",
                        "",
                        "Evens the spacing of the surfels and leaves the surface where it is.",
                        Motion::Along,
                        0.5,
                        {},
                        relax,
                        Writes::Count};

} // namespace sculpt
