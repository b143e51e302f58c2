// The first look around everything that was touched, in lanes: of most surfels it says that nothing is to be done.
#include "core/base/parallel.h"
#include "core/process/resampling/resample_set.h"
#include "core/surface/evaluation/free_space.h"

namespace process {

/// Blocks per task.
constexpr std::size_t grain = 8;
/// The scan computes in another order: what may be on either side of a limit is worth it.
constexpr float rounding = 1e-4f;

static surface::FreeSpaceQuery queryFor(const tree::SurfelTree& tree, float close, float spacing) {
    using Sheets = surface::FreeSpaceQuery::Sheets;
    const Facing facing(*tree.layout());
    const Sheets sheets = !facing.known() ? Sheets::All : facing.oriented() ? Sheets::Signed : Sheets::Unsigned;
    return {close * spacing * (1 + rounding), fillDistance * spacing, fillClear * spacing * (1 - rounding), sheets,
            Facing::leastCosine};
}

tree::Selection restlessOf(const surface::Surface& version, const tree::Selection& touched,
                           const ResampleOptions& options) {
    if (options.field || options.targetOf) // its query is for one spacing
        return touched;
    const tree::SurfelTree& tree = version.tree();
    const surface::FreeSpaceQuery query = queryFor(tree, lookedAt(options), options.spacing);
    tree::Selection out = touched;
    base::parallelChunks(out.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        surface::FreeSpaceFinder space(tree, query);
        for (std::size_t i = begin; i < end; ++i)
            out[i].slots = space.restless(*tree.block(out[i].block), out[i].slots);
    });
    std::erase_if(out, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return out;
}

tree::Selection withRoom(const surface::Surface& version, tree::Selection among,
                         const std::function<float(const surfel::SurfelBlock&)>& spacingOf) {
    const tree::SurfelTree& tree = version.tree();
    base::parallelFor(among.size(), grain, [&](std::size_t i) {
        const surfel::BlockPtr block = tree.block(among[i].block);
        surface::FreeSpaceFinder space(tree, queryFor(tree, 0, spacingOf(*block)));
        among[i].slots = space.restless(*block, among[i].slots);
    });
    std::erase_if(among, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    return among;
}

} // namespace process
