// The first look around everything that was touched, in lanes: of most surfels it says that nothing is to be done.
#include "core/base/parallel.h"
#include "core/process/resampling/resample_set.h"
#include "core/surface/evaluation/free_space.h"

namespace process {

/// Blocks per task.
constexpr std::size_t grain = 8;
/// The scan computes in another order: what may be on either side of a limit is worth it.
constexpr float rounding = 1e-4f;

tree::Selection restlessOf(const surface::Surface& version, const tree::Selection& touched,
                           const ResampleOptions& options) {
    if (options.field) // its query is for one spacing
        return touched;
    const float spacing = options.spacing;
    using Sheets = surface::FreeSpaceQuery::Sheets;
    const Facing facing(*version.tree().layout());
    const surface::FreeSpaceQuery query{lookedAt(options) * spacing * (1 + rounding), fillDistance * spacing,
                                        fillClear * spacing * (1 - rounding),
                                        !facing.known()     ? Sheets::All
                                        : facing.oriented() ? Sheets::Signed
                                                            : Sheets::Unsigned,
                                        Facing::leastCosine};
    tree::Selection out = touched;
    base::parallelChunks(out.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        surface::FreeSpaceFinder space(version.tree(), query);
        for (std::size_t i = begin; i < end; ++i)
            out[i].slots = space.restless(*version.tree().block(out[i].block), out[i].slots);
    });
    std::erase_if(out, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return out;
}

} // namespace process
