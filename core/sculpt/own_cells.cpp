#include "core/sculpt/own_cells.h"

#include <bit>
#include <map>

namespace sculpt {

namespace {

/// The cell of all its surfels; nothing where they have several.
std::optional<std::uint32_t> onlyCell(const cells::LabelLayout& labels, const surfel::SurfelBlock& block) {
    const std::uint32_t first = labels.cellAt(block, 0);
    for (int slot = 1; slot < block.size(); ++slot)
        if (labels.cellAt(block, slot) != first)
            return std::nullopt;
    return first;
}

} // namespace

OwnCells::OwnCells(const surface::Surface& surface, std::span<const BrushBlock> blocks) {
    const tree::SurfelTree& tree = surface.tree();
    if (tree.empty() || !(m_labels = cells::LabelLayout::of(*tree.layout())))
        return;
    std::map<std::uint32_t, std::optional<std::uint32_t>> known;
    std::set<std::uint32_t> needed;
    for (const BrushBlock& in : blocks) {
        std::vector<std::uint32_t> around;
        bool several = false;
        tree.forBlocksInSupport(
            in.block->box(),
            [&](std::uint32_t number, const surfel::SurfelBlock& block) {
                const auto [at, fresh] = known.try_emplace(number);
                if (fresh)
                    at->second = onlyCell(*m_labels, block);
                several |= !at->second || *at->second != m_labels->cellAt(*in.block, 0);
                around.push_back(number);
            },
            surface::queryReach(surface.supportScale()));
        if (!several)
            continue;
        m_mixed.insert(in.number);
        needed.insert(around.begin(), around.end());
    }
    if (m_mixed.empty())
        return;
    surfel::SurfelList list;
    list.layout = tree.layout();
    std::vector<std::uint32_t> words(tree.layout()->words());
    for (const std::uint32_t number : needed) {
        const surfel::BlockPtr block = tree.block(number);
        for (int slot = 0; slot < block->size(); ++slot) {
            block->extra(slot, words);
            list.append(block->surfel(slot), words);
        }
    }
    m_near = cells::CellSurface::of({tree::SurfelTree::build(list), surface.definition()});
}

void OwnCells::Evaluator::replace(const BrushBlock& in, unsigned clusters, std::span<surface::SelfLanes> at) {
    if (!m_source || !m_own.m_mixed.contains(in.number))
        return;
    for (; clusters != 0; clusters &= clusters - 1) {
        const int cluster = std::countr_zero(clusters);
        surface::SelfLanes& out = at[static_cast<std::size_t>(cluster)];
        const int begin = cluster * surfel::clusterSize, end = std::min(begin + surfel::clusterSize, in.block->size());
        for (int slot = begin; slot < end; ++slot) {
            m_source->setScale(static_cast<double>(in.block->support(slot)));
            m_source->moveTo(base::cast<double>(in.block->position(slot)));
            const std::size_t own = m_source->find(m_own.m_labels->cellAt(*in.block, slot));
            if (m_source->alone() || own == cells::CellSourcef::none)
                continue;
            const cells::CellField& field = m_source->at(own, surface::Need::Gradient);
            const int lane = slot - begin;
            out.status[lane] = field.status;
            out.value[lane] = static_cast<float>(field.value);
            out.unit[lane] = static_cast<float>(field.unit);
            for (std::size_t k = 0; k < 3; ++k)
                out.gradient[k][lane] = static_cast<float>(field.gradient[k]);
        }
    }
}

} // namespace sculpt
