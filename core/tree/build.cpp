// Building: Morton order, runs of at most 512 blocks cut where the curve jumps, kd cuts inside a run, and a balanced
// hierarchy of kd cuts above the blocks (tree/README 2).
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/tree/cutting.h"
#include "core/tree/grouping.h"
#include "core/tree/morton.h"
#include "core/tree/surfel_tree.h"

#include <cassert>

namespace tree {

constexpr std::size_t blocksPerRun = 512;
constexpr std::size_t grain = 1 << 15;

/// Box of all positions; throws for a surfel that no tree can hold.
static base::Box3f checkedBox(const surfel::SurfelList& surfels, const base::Progress& progress) {
    std::vector<base::Box3f> boxes(base::chunkCount(surfels.size(), grain));
    base::parallelChunks(surfels.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i) {
            requireValid(surfels.items[i], i);
            boxes[chunk].extend(surfels.items[i].position);
        }
    });
    progress.step(0.05, "indexing");
    base::Box3f box;
    for (const base::Box3f& part : boxes)
        box.extend(part);
    return box;
}

static Children cutRun(const surfel::SurfelList& surfels, std::span<const MortonKey> keys) {
    Pool pool;
    pool.list = &surfels;
    CutLanes places(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const base::Vec3f& p = surfels.items[indexOf(keys[i])].position;
        places.axis(0)[i] = p.x, places.axis(1)[i] = p.y, places.axis(2)[i] = p.z;
        places.sources()[i] = Pool::listBase + indexOf(keys[i]);
    }
    Children out;
    for (auto& block : cutIntoBlocks(pool, places, blocksFor(keys.size()), surfels.layout->words()))
        out.push_back(asChild(std::move(block)));
    return out;
}

Children blocksOf(const surfel::SurfelList& surfels, const base::Progress& progress) {
    assert(surfels.size() < Pool::listBase);
    assert(surfels.extra.size() == surfels.size() * surfels.layout->words());
    if (surfels.items.empty())
        return {};
    const base::LargeArray<MortonKey> keys = sortedKeys(surfels.items, checkedBox(surfels, progress));
    progress.step(0.25, "indexing");
    const std::vector<std::size_t> ends = cutRuns(keys, blocksPerRun * blockTarget);
    std::vector<Children> runs(ends.size());
    base::parallelFor(ends.size(), 1, [&](std::size_t run) {
        if (progress.cancel && progress.cancel->load(std::memory_order_relaxed))
            throw base::Cancelled();
        const std::size_t begin = run == 0 ? 0 : ends[run - 1];
        runs[run] = cutRun(surfels, std::span(keys).subspan(begin, ends[run] - begin));
    });
    progress.step(0.9, "indexing");
    Children out;
    for (Children& run : runs)
        std::move(run.begin(), run.end(), std::back_inserter(out));
    return out;
}

SurfelTree SurfelTree::build(const surfel::SurfelList& surfels, const base::Progress& progress) {
    const Children blocks = blocksOf(surfels, progress);
    SurfelTree tree(blocks.empty() ? NodePtr() : buildAbove(blocks), surfels.layout);
    progress.step(1, "indexing");
    return tree;
}

} // namespace tree
