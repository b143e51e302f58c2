#include "core/solid/whole_parts.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/surface/definition.h"

#include <array>
#include <bit>

namespace solid {

using base::Vec3f;

namespace {

constexpr float linkSpacings = 2.2F;
constexpr std::size_t blocksAtOnce = 256; ///< whose links are kept before they are joined

class GoneSurfels {
  public:
    GoneSurfels(const tree::SurfelTree& tree, const tree::Selection& gone)
        : m_tree(tree), m_gone(gone), m_of(tree.blockCount(), none), m_numbers(gone.size()) {
        for (std::size_t k = 0; k < gone.size(); ++k) {
            m_of[gone[k].block] = static_cast<std::uint32_t>(k);
            m_numbers[k].fill(none);
            for (std::size_t slot = 0; slot < surfel::blockCapacity; ++slot)
                if (gone[k].slots[slot])
                    m_numbers[k][slot] = m_count++;
        }
    }

    std::size_t wholeParts() const {
        base::DisjointSets sets(m_count);
        std::vector<std::uint8_t> beside(m_count, 0); // a surfel that stays
        std::vector<Links> links;
        for (std::size_t from = 0; from < m_gone.size(); from += blocksAtOnce) {
            links.assign(std::min(blocksAtOnce, m_gone.size() - from), {});
            base::parallelFor(links.size(), 1, [&](std::size_t k) { links[k] = linksOf(from + k, beside); });
            for (const Links& block : links)
                for (const auto& [a, b] : block)
                    sets.join(a, b);
        }
        for (std::uint32_t i = 0; i < beside.size(); ++i)
            if (beside[i])
                beside[sets.find(i)] = 1;
        std::size_t out = 0;
        for (std::uint32_t i = 0; i < beside.size(); ++i)
            out += sets.find(i) == i && !beside[i];
        return out;
    }

  private:
    static constexpr std::uint32_t none = ~0U;
    using Links = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    /// Of the surfels of one block with those before them.
    Links linksOf(std::size_t k, std::vector<std::uint8_t>& beside) const {
        Links out;
        const surfel::BlockPtr block = m_tree.block(m_gone[k].block);
        constexpr auto reach = static_cast<float>(linkSpacings * surface::spacingOfUnit);
        for (int slot = 0; slot < block->size(); ++slot) {
            const std::uint32_t own = m_numbers[k][static_cast<std::size_t>(slot)];
            if (own == none)
                continue;
            const Vec3f p = block->position(slot);
            const float support = block->support(slot);
            const base::Box3f near = base::Box3f{p, p}.inflated(reach * support);
            const auto each = [&](std::uint32_t number, const surfel::SurfelBlock& other) {
                const std::uint32_t* numbers = m_of[number] == none ? nullptr : m_numbers[m_of[number]].data();
                for (unsigned in = other.boundsLanes().supporting(near, reach) & other.clusterMask(); in;
                     in &= in - 1) {
                    const int first = std::countr_zero(in) * surfel::clusterSize;
                    const int end = std::min(other.size(), first + surfel::clusterSize);
                    for (int i = first; i < end; ++i) {
                        const std::uint32_t one = numbers ? numbers[i] : none;
                        if (one != none && one >= own)
                            continue;
                        const float length = reach * std::max(support, other.support(i));
                        if (!(distanceSq(other.position(i), p) < length * length))
                            continue;
                        if (one == none)
                            beside[own] = 1;
                        else
                            out.emplace_back(one, own);
                    }
                }
            };
            m_tree.forBlocksInSupport(near, each, reach);
        }
        return out;
    }

    const tree::SurfelTree& m_tree;
    const tree::Selection& m_gone;
    std::vector<std::uint32_t> m_of; ///< by block, its place in `gone`
    std::vector<std::array<std::uint32_t, surfel::blockCapacity>>
        m_numbers; ///< of a gone block's surfels that are gone
    std::uint32_t m_count = 0;
};

} // namespace

std::size_t wholeParts(const tree::SurfelTree& tree, const tree::Selection& gone) {
    return gone.empty() ? 0 : GoneSurfels(tree, gone).wholeParts();
}

std::size_t partsThatGo(const tree::SurfelTree& tree, const tree::Edit& edit) {
    tree::Selection out;
    for (const tree::BlockEdit& block : edit.blocks)
        if (block.removed.any())
            out.push_back({block.block, block.removed});
    return wholeParts(tree, out);
}

std::size_t partsWhere(const tree::SurfelTree& tree, const std::function<bool(std::size_t)>& gone) {
    tree::Selection out;
    const std::vector<std::size_t> first = tree.firstSurfels();
    for (std::uint32_t b = 0; b < tree.blockCount(); ++b) {
        tree::SelectedBlock block{b, {}};
        for (int slot = 0; slot < tree.block(b)->size(); ++slot)
            block.slots[static_cast<std::size_t>(slot)] = gone(first[b] + static_cast<std::size_t>(slot));
        if (block.slots.any())
            out.push_back(block);
    }
    return wholeParts(tree, out);
}

} // namespace solid
