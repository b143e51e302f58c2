#include "core/selection/flood.h"

#include "core/base/parallel.h"
#include "core/selection/field.h"
#include "core/selection/links.h"
#include "core/surface/curvature.h"

#include <algorithm>

namespace selection {

using surfel::SurfelBlock;
using tree::SelectedBlock;

namespace {

class Flood {
  public:
    Flood(const surface::Surface& surface, const FloodLimits& limits)
        : m_surface(surface), m_links(surface), m_limits(limits), m_blocks(blocksOf(surface.tree())),
          m_seen(m_blocks.size()), m_in(m_blocks.size()),
          m_hidden(limits.hidden ? -1 : channelOf(*surface.tree().layout(), Field::Hidden)),
          m_cosine(limits.angleRad < std::numbers::pi ? static_cast<float>(std::cos(limits.angleRad)) : -2.0f) {}

    tree::Selection from(const tree::Selection& seeds, const base::Progress& progress) {
        for (const SelectedBlock& seed : seeds)
            m_seen[seed.block] = m_in[seed.block] = seed.slots;
        std::size_t reached = sizeOf(seeds);
        for (tree::Selection wave = seeds; !wave.empty();) {
            progress.step(static_cast<double>(reached) / static_cast<double>(m_surface.tree().size()),
                          "Following the surface");
            wave = next(wave);
            reached += sizeOf(wave);
        }
        tree::Selection out;
        for (std::size_t b = 0; b < m_in.size(); ++b)
            if (m_in[b].any())
                out.push_back({static_cast<std::uint32_t>(b), m_in[b]});
        return out;
    }

  private:
    /// What one block's surfels of the wave are linked with and was not seen yet.
    tree::Selection reachedBy(const SelectedBlock& of) const {
        const SurfelBlock& block = *m_blocks[of.block];
        const bool oriented = m_surface.tree().layout()->oriented;
        tree::Selection out;
        for (int slot = 0; slot < block.size(); ++slot) {
            if (!of.slots[static_cast<std::size_t>(slot)])
                continue;
            const base::Vec3f n = block.normal(slot);
            m_links.forEach(block, slot, [&](std::uint32_t number, const SurfelBlock& other, int k, float) {
                const auto at = static_cast<std::size_t>(k);
                const float cosine = dot(n, other.normal(k));
                if (m_seen[number][at] || (oriented ? cosine : std::abs(cosine)) < m_cosine ||
                    valueAt(other, m_hidden, k) >= half)
                    return;
                const auto found = std::find_if(out.begin(), out.end(),
                                                [&](const SelectedBlock& each) { return each.block == number; });
                (found != out.end() ? *found : out.emplace_back(SelectedBlock{number, {}})).slots.set(at);
            });
        }
        return out;
    }

    tree::Selection next(const tree::Selection& wave) {
        std::vector<tree::Selection> parts(wave.size());
        base::parallelFor(wave.size(), 2, [&](std::size_t i) { parts[i] = reachedBy(wave[i]); });
        tree::Selection all;
        for (const tree::Selection& part : parts)
            all.insert(all.end(), part.begin(), part.end());
        std::sort(all.begin(), all.end(),
                  [](const SelectedBlock& a, const SelectedBlock& b) { return a.block < b.block; });
        tree::Selection out;
        for (const SelectedBlock& each : all)
            if (!out.empty() && out.back().block == each.block)
                out.back().slots |= each.slots;
            else
                out.push_back(each);
        for (const SelectedBlock& each : out)
            m_seen[each.block] |= each.slots;
        if (std::isfinite(m_limits.curvature))
            dropCurved(out);
        for (const SelectedBlock& each : out)
            m_in[each.block] |= each.slots;
        return out;
    }

    void dropCurved(tree::Selection& wave) const {
        std::vector<base::Vec3f> x;
        for (const SelectedBlock& each : wave)
            for (int slot = 0; slot < m_blocks[each.block]->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)])
                    x.push_back(m_blocks[each.block]->position(slot));
        std::vector<surface::Curvature> at(x.size());
        surface::curvature(m_surface, x, at);
        std::size_t i = 0;
        for (SelectedBlock& each : wave)
            for (std::size_t slot = 0; slot < each.slots.size(); ++slot)
                if (each.slots[slot]) {
                    const surface::Curvature& c = at[i++];
                    each.slots[slot] = c.ok() && std::max(std::abs(c.k1), std::abs(c.k2)) <= m_limits.curvature;
                }
        std::erase_if(wave, [](const SelectedBlock& each) { return each.slots.none(); });
    }

    const surface::Surface& m_surface;
    Links m_links;
    FloodLimits m_limits;
    std::vector<const SurfelBlock*> m_blocks;
    std::vector<std::bitset<surfel::blockCapacity>> m_seen, m_in;
    int m_hidden;   ///< channel of what ends it; -1: nothing does
    float m_cosine; ///< least that a link's normals may have
};

} // namespace

tree::Selection flooded(const surface::Surface& surface, const tree::Selection& seeds, const FloodLimits& limits,
                        const base::Progress& progress) {
    return Flood(surface, limits).from(seeds, progress);
}

tree::Selection nearestTo(const tree::SurfelTree& tree, const base::Vec3d& x) {
    const int hidden = channelOf(*tree.layout(), Field::Hidden);
    std::vector<tree::Neighbour> found;
    for (std::size_t count = 1; found.size() < tree.size(); count *= 16) {
        tree.nearest(base::cast<float>(x), count, found);
        const auto shown = std::ranges::find_if(
            found, [&](const tree::Neighbour& each) { return valueAt(*each.block, hidden, each.slot) < half; });
        if (shown != found.end()) {
            found = {*shown};
            break;
        }
    }
    found.resize(1);
    tree::Selection out;
    for (const tree::Neighbour& each : found) {
        out.push_back({each.blockNumber, {}});
        out.back().slots.set(static_cast<std::size_t>(each.slot));
    }
    return out;
}

} // namespace selection
