#include "core/sculpt/tools/relax.h"

#include "core/process/resampling/resample.h"
#include "core/sculpt/tools/area_spacing.h"
#include "core/sculpt/tools/inside.h"
#include "core/sculpt/tools/turns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace sculpt {

/// Sweeps of a dab of full strength.
constexpr float fullSweeps = 5;
/// What stays inside the rim, in spacings.
constexpr float margin = 1.5f;
/// Supports under the brush that differ by no more are made for one spacing.
constexpr float alike = 1.25f;

static int firstOf(const tree::SelectedBlock& each) {
    int slot = 0;
    while (!each.slots[static_cast<std::size_t>(slot)])
        ++slot;
    return slot;
}

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

/// What the stroke has measured around the surfels that the last dab looked at, most of which have not moved since, and
/// what it has seen to.
struct RelaxMemory : ToolMemory {
    AreaSpacing found;
    Turns turns;
    int sweeps = 0; ///< of the strongest dab
    RelaxMemory(const surface::Surface& first, float spacing, const Dab& dab)
        : found(first, spacing), turns(dab.centre, dab.radius) {}
};

static std::vector<surfel::BlockPtr> blocksOf(const tree::SurfelTree& tree, const std::set<std::uint32_t>& numbers) {
    std::vector<surfel::BlockPtr> out;
    for (const std::uint32_t number : numbers)
        out.push_back(tree.block(number));
    return out;
}

/// The largest target of these. All around them is measured then.
static float measureAround(const tree::SurfelTree& tree, const tree::Selection& which, AreaSpacing& found) {
    std::set<std::uint32_t> numbers;
    for (const tree::SelectedBlock& each : which)
        numbers.insert(each.block);
    found.measure(blocksOf(tree, numbers));
    std::vector<base::Box3f> boxes(which.size());
    float most = 0;
    for (std::size_t i = 0; i < which.size(); ++i) {
        const surfel::BlockPtr block = tree.block(which[i].block);
        for (int slot = 0; slot < block->size(); ++slot)
            if (which[i].slots[static_cast<std::size_t>(slot)])
                boxes[i].extend(block->position(slot)), most = std::max(most, found.at(*block, slot));
    }
    for (const base::Box3f& box : boxes)
        tree.forBlocksInBall(box.centre(), 0.5f * box.diagonal() + inTheWay * most,
                             [&](std::uint32_t number, const surfel::SurfelBlock&) { numbers.insert(number); });
    found.measure(blocksOf(tree, numbers));
    return most;
}

/// Evens these. `spacing`: of one of them.
static tree::Edit evened(const surface::Surface& version, const tree::Selection& which, float spacing, int sweeps,
                         AreaSpacing& found) {
    process::ResampleOptions options;
    options.spacing = spacing;
    options.sweeps = sweeps;
    options.relaxAll = true;
    options.order = process::Order::RelaxOnly;
    if (version.definition().support <= 0 && !oneSpacing(version.tree(), which)) {
        // Nothing has left its surface: what is measured on the first version holds here.
        options.spacing = measureAround(version.tree(), which, found);
        options.targetOf = [&](const surfel::SurfelBlock& block, int slot) { return found.at(block, slot); };
    }
    return process::resample(version, which, options);
}

static tree::Edit relax(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const tree::SurfelTree& tree = version.tree();
    const float spacing = process::localSpacing(version, dab.centre);
    if (dab.strength == 0 || !(spacing > 0))
        return {};
    std::unique_ptr<ToolMemory> once;
    auto& memory = memoryOf<RelaxMemory>(dab, once, dab.first ? *dab.first : version, spacing, dab);
    const int sweeps = std::max(1, static_cast<int>(std::lround(fullSweeps * std::abs(dab.strength))));
    memory.sweeps = std::max(memory.sweeps, sweeps);
    memory.found.keepOnly(blocksAround(tree, dab.centre, dab.radius + inTheWay * spacing));
    const tree::Selection which =
        memory.turns.next(tree, inside(tree, brush, dab.radius - margin * spacing), dab.centre);
    return evened(version, which, spacing, sweeps, memory.found);
}

/// What the dabs have left, a part of it.
static tree::Edit relaxRest(const surface::Surface& version, ToolMemory& stroke) {
    auto& memory = static_cast<RelaxMemory&>(stroke);
    for (;;) {
        const tree::Selection which = memory.turns.rest(version.tree());
        if (which.empty())
            return {};
        const surfel::BlockPtr block = version.tree().block(which[0].block);
        const float spacing = process::localSpacing(version, block->position(firstOf(which[0])));
        tree::Edit edit = evened(version, which, spacing, memory.sweeps, memory.found);
        if (!edit.empty())
            return edit;
    }
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
                        Writes::Count,
                        {},
                        relaxRest};

} // namespace sculpt
