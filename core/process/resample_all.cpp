// Resampling of a whole model to a spacing.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/resample.h"
#include "core/process/spacing.h"

#include <algorithm>
#include <cmath>

namespace process {

/// The spacing changes by at most this factor at a time: fill looks for room one spacing away, not ten.
constexpr float largestChange = 1.5f;
/// More surfels than this are asked for by mistake.
constexpr double mostSurfels = 2e8;

static void check(const surface::Surface& surface, float spacing, float present) {
    if (!(spacing > 0) || !std::isfinite(spacing))
        throw base::Error("spacing must be a length greater than 0", "resample");
    const double ratio = double(present) / double(spacing);
    const double count = double(surface.tree().size()) * ratio * ratio;
    if (count > mostSurfels)
        throw base::Error("that spacing would make about " + std::to_string(std::llround(count / 1e6)) +
                              " million surfels",
                          "resample", "choose a wider one");
}

/// The same surfels with one support.
static tree::SurfelTree withSupport(const tree::SurfelTree& tree, float support) {
    tree::Edit edit;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock&) {
        edit.blocks.push_back({number, {}, {}});
    });
    base::parallelFor(edit.blocks.size(), 16, [&](std::size_t i) {
        const surfel::MutableBlockPtr changed = tree.block(edit.blocks[i].block)->clone();
        for (int slot = 0; slot < changed->size(); ++slot)
            changed->channel(slot / surfel::clusterSize, surfel::Support)[slot % surfel::clusterSize] = support;
        changed->seal();
        edit.blocks[i].changed = changed;
    });
    edit.inserted.layout = tree.layout();
    return tree.apply(edit);
}

ResampleResult resampleAll(const surface::Surface& surface, float spacing, int maxRounds,
                           const base::Progress& progress) {
    ResampleResult out{surface, 0, false};
    if (surface.tree().empty())
        return out;
    progress.step(0, "Measuring spacing");
    const float present = summarise(spacings(surface.tree().surfels().items, progress)).median;
    check(surface, spacing, present);
    const int changes = std::max(
        1, static_cast<int>(std::ceil(std::abs(std::log(spacing / present)) / std::log(largestChange) - 0.01f)));
    for (int change = 1; change <= changes; ++change) {
        ResampleOptions options;
        const float share = static_cast<float>(change) / static_cast<float>(changes);
        options.spacing = change == changes ? spacing : present * std::pow(spacing / present, share);
        options.support = supportOf(surface.definition(), options.spacing);
        out.settled = false;
        for (int round = 0; round < maxRounds && !out.settled; ++round) {
            progress.step((double(change - 1) + double(round) / maxRounds) / changes, "Resampling");
            const tree::Edit edit = resample(out.surface, selectAll(out.surface.tree()), options, surface);
            out.settled = edit.empty();
            out.surface = {out.surface.tree().apply(edit), surface.definition()};
            ++out.rounds;
        }
    }
    const float support = supportOf(surface.definition(), spacing);
    out.surface = {withSupport(out.surface.tree(), support), surface.definition()};
    progress.step(1, "Resampling");
    return out;
}

} // namespace process
