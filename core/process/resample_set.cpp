#include "core/process/resample_set.h"

#include <algorithm>

namespace process {

/// Off-centre values at which a place belongs to an open border and at which nothing grows, in units of h (RESAMPLING
/// 4). A straight border has 0.212 h with Wendland weights and 0.564 with the Gaussian's (alg. 0).
constexpr float pinnedLimit = 0.12f, grownLimit = 0.15f;
constexpr float gaussianOver = 0.564190f / 0.212207f;

/// How far around the touched surfels others can be in the way: a new surfel's distance, and its own reach.
constexpr float margin = fillDistance + fillStray + fillApart;

SampleSet::SampleSet(const surface::Surface& v, const tree::Selection& touched, const ResampleOptions& o,
                     const surface::Surface& f)
    : version(v), frozen(f), options(o), spacing(o.spacing), facing(*v.tree().layout()), pinned(pinnedLimit),
      grown(grownLimit), grid(v.tree().bounds().centre(), fillReach * o.spacing) {
    if (f.definition().weight == surface::Weight::Gaussian)
        pinned *= gaussianOver, grown *= gaussianOver;
    if (options.support <= 0)
        options.support = supportOf(v.definition(), spacing);
    collect(touched);
    oldGradient.resize(size());
    rebuildGrid();
}

namespace {

/// Blocks with surfels within `reach` of the selected surfels' boxes, by number, and the box of all of those.
struct Surroundings {
    std::vector<std::uint32_t> blocks;
    base::Box3f box;
};

Surroundings surroundings(const tree::SurfelTree& tree, const tree::Selection& touched, float reach) {
    Surroundings out;
    for (const tree::SelectedBlock& selected : touched) {
        const surfel::BlockPtr block = tree.block(selected.block);
        base::Box3f box;
        for (int slot = 0; slot < block->size(); ++slot)
            if (selected.slots[static_cast<std::size_t>(slot)])
                box.extend(block->position(slot));
        out.box.extend(box);
        tree.forBlocksInBall(box.centre(), 0.5f * box.diagonal() + reach,
                             [&](std::uint32_t number, const surfel::SurfelBlock&) { out.blocks.push_back(number); });
    }
    std::sort(out.blocks.begin(), out.blocks.end());
    out.blocks.erase(std::unique(out.blocks.begin(), out.blocks.end()), out.blocks.end());
    out.box = out.box.inflated(reach);
    return out;
}

} // namespace

void SampleSet::collect(const tree::Selection& touched) {
    const Surroundings around = surroundings(version.tree(), touched, margin * spacing);
    auto selected = touched.begin();
    for (const std::uint32_t number : around.blocks) {
        while (selected != touched.end() && selected->block < number)
            ++selected;
        const bool any = selected != touched.end() && selected->block == number;
        const auto local = static_cast<std::uint32_t>(block.size());
        block.push_back(version.tree().block(number));
        blockNumber.push_back(number);
        const surfel::SurfelBlock& b = *block.back();
        for (int slot = 0; slot < b.size(); ++slot) {
            const bool isTouched = any && selected->slots[static_cast<std::size_t>(slot)];
            const base::Vec3f p = b.position(slot);
            if (!isTouched && !around.box.contains(p))
                continue;
            position.push_back(p);
            normal.push_back(b.normal(slot));
            flags.push_back(
                static_cast<std::uint8_t>((isTouched ? Touched | Scan : 0) | (b.mask(slot) > 0 ? Masked : 0)));
            source.push_back({local, static_cast<std::uint8_t>(slot)});
        }
    }
}

std::uint32_t SampleSet::bear(const base::Vec3f& place, const base::Vec3f& direction) {
    const auto index = static_cast<std::uint32_t>(size());
    position.push_back(place);
    normal.push_back(direction);
    flags.push_back(Touched | New | Moved);
    grid.insert({place, index});
    return index;
}

void SampleSet::rebuildGrid() {
    std::vector<PointGrid::Entry> entries;
    entries.reserve(size());
    for (std::uint32_t i = 0; i < size(); ++i)
        if (!is(i, Gone))
            entries.push_back({position[i], i});
    grid.build(entries);
}

void SampleSet::scanAround(std::size_t i, float radius) {
    grid.forNear(position[i], radius, [&](const PointGrid::Entry& e) {
        if (is(e.index, Touched) && !is(e.index, Gone) && distanceSq(e.position, position[i]) < radius * radius)
            mark(e.index, Scan);
    });
}

} // namespace process
