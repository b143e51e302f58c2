#include "core/cells/cell_surface.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/clusters.h"

#include <bit>
#include <limits>
#include <set>

namespace cells {

namespace {

constexpr std::uint32_t several = std::numeric_limits<std::uint32_t>::max();

/// The cell of a cluster's surfels, or `several`.
std::uint32_t cellOf(const LabelLayout& labels, const surfel::SurfelBlock& block, int cluster) {
    const int begin = cluster * surfel::clusterSize, end = std::min(begin + surfel::clusterSize, block.size());
    const std::uint32_t out = labels.cellAt(block, begin);
    for (int slot = begin + 1; slot < end; ++slot)
        if (labels.cellAt(block, slot) != out)
            return several;
    return out;
}

} // namespace

std::optional<CellSurface> CellSurface::of(const surface::Surface& surface) {
    const tree::SurfelTree& tree = surface.tree();
    const auto labels = LabelLayout::of(*tree.layout());
    if (!labels || surface.definition().manifold != surface::Manifold::Surface || tree.empty())
        return std::nullopt;
    std::vector<const surfel::SurfelBlock*> blocks(tree.blockCount());
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) { blocks[number] = &block; });
    constexpr std::size_t perBlock = surfel::clustersPerBlock;
    std::vector<std::uint32_t> cell(blocks.size() * perBlock, several);
    base::parallelFor(blocks.size(), 64, [&](std::size_t b) {
        for (int c = 0; c < blocks[b]->clusterCount(); ++c)
            cell[b * perBlock + static_cast<std::size_t>(c)] = cellOf(*labels, *blocks[b], c);
    });

    const float reach = surface::queryReach(surface.supportScale());
    std::vector<unsigned> mixed(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        for (int c = 0; c < blocks[b]->clusterCount(); ++c) {
            const std::uint32_t own = cell[b * perBlock + static_cast<std::size_t>(c)];
            const surfel::ClusterBounds bounds = blocks[b]->bounds(c);
            const base::Box3f box = bounds.box.inflated(surfel::surfaceReach * reach * bounds.maxSupport);
            bool other = own == several;
            if (!other)
                tree.forBlocksInSupport(
                    box,
                    [&](std::uint32_t number, const surfel::SurfelBlock& block) {
                        const unsigned there = block.boundsLanes().supporting(box, reach) & block.clusterMask();
                        for (unsigned left = other ? 0 : there; left != 0; left &= left - 1)
                            other |= cell[number * perBlock + static_cast<std::size_t>(std::countr_zero(left))] != own;
                    },
                    reach);
            mixed[b] |= static_cast<unsigned>(other) << c;
        }
    });
    auto table = std::make_shared<Mixed>();
    table->reserve(blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b)
        table->emplace(blocks[b], mixed[b]);
    CellSurface out(surface, *labels);
    out.m_mixed = std::move(table);
    out.m_parts = std::make_shared<CellParts>(tree, *labels);
    return out;
}

CellSurface CellSurface::unprepared(const surface::Surface& surface, const LabelLayout& labels) {
    CellSurface out(surface, labels);
    out.m_mixed = std::make_shared<Mixed>();
    return out;
}

bool CellSurface::mixedAlong(const base::Rayf& ray, float t) const {
    bool out = false;
    m_surface.tree().alongRay(ray, [&](const surfel::SurfelBlock& block, int cluster, float enter, float) {
        if (enter > t)
            return false;
        out = mixed(block, cluster);
        return !out;
    });
    return out;
}

CellCounts countCells(const surfel::SurfelList& surfels) {
    CellCounts out;
    const auto labels = LabelLayout::of(*surfels.layout);
    if (!labels)
        return out;
    std::set<std::uint32_t> cells;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const Label label = labels->at(surfels.extraOf(i));
        cells.insert(label.cell);
        if (label.meeting != Meeting::None)
            pairs.insert(std::minmax(label.cell, label.partner));
        out.convex += label.meeting == Meeting::Convex ? 1 : 0;
        out.concave += label.meeting == Meeting::Concave ? 1 : 0;
    }
    out.cells = cells.size();
    out.pairs = pairs.size();
    return out;
}

} // namespace cells
