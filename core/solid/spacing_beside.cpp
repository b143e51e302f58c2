#include "core/solid/spacing_beside.h"

#include "core/base/parallel.h"
#include "core/process/estimation/spacing_sample.h"

#include <algorithm>

namespace solid {

using base::Vec3d;

SpacingBeside::SpacingBeside(const tree::SurfelTree& tree, const Side& side) {
    surfel::SurfelList beside;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        const base::Box3f box = block.box().inflated(block.maxSupport());
        if (!side.meets({base::cast<double>(box.lo), base::cast<double>(box.hi)}))
            return;
        for (int slot = 0; slot < block.size(); ++slot) {
            surfel::Surfel s = block.surfel(slot);
            if (std::abs(side.at(base::cast<double>(s.position)).value) < static_cast<double>(s.support))
                beside.append(s, {});
        }
    });
    base::parallelFor(beside.items.size(), 16, [&](std::size_t i) {
        surfel::Surfel& s = beside.items[i];
        if (const float spacing = process::spacingAround(tree, s.position); spacing > 0)
            s.support = spacing;
    });
    if (beside.size() > 0)
        m_beside = tree::SurfelTree::build(beside);
}

SpacingBeside::SpacingBeside(const Loop& loop) {
    surfel::SurfelList beside;
    for (const LoopPoint& p : loop.points)
        beside.items.push_back({base::cast<float>(p.position), {}, static_cast<float>(p.spacing)});
    m_beside = tree::SurfelTree::build(beside);
}

double SpacingBeside::at(const Vec3d& x) const {
    constexpr std::size_t around = 5;
    std::vector<tree::Neighbour> near;
    m_beside.nearest(base::cast<float>(x), around, near);
    std::vector<double> spacings;
    for (const tree::Neighbour& each : near)
        spacings.push_back(static_cast<double>(each.block->support(each.slot)));
    std::sort(spacings.begin(), spacings.end());
    return spacings[spacings.size() / 2];
}

} // namespace solid
