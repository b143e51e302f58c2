#include "core/sculpt/tools/area_spacing.h"

#include "core/tree/nearest_together.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sculpt {

/// Nearest surfels asked for, the surfel itself among them, and how many have to face alike.
constexpr std::size_t asked = 32;
constexpr float enough = 16;
/// What the disc out to the k-th of the others holds beside these: half a surfel more on a lattice, one less where they
/// lie by chance.
constexpr float held = -0.25f;
/// A disc whose surfels lie to one side by more than this part of its radius is cut off by a border.
constexpr float aside = 0.3f;

class AreaSpacing::Search {
  public:
    explicit Search(const AreaSpacing& of)
        : m_kept(of.m_kept), m_around(of.m_kept.first().tree(), asked), m_nearest(of.m_kept) {}

    /// REQUIRES: at most 16 slots, as many answers.
    void at(const surfel::SurfelBlock& block, std::span<const int> slots, std::span<float> out) {
        std::array<base::Vec3f, surfel::clusterSize> places;
        for (std::size_t i = 0; i < slots.size(); ++i)
            places[i] = block.position(slots[i]);
        m_around.at(std::span(places).first(slots.size()));
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const std::span<const tree::Neighbour> near = m_around.of(i);
            const std::span few = near.first(std::min(near.size(), KeptSpacing::Search::asked));
            const base::Vec3f n = block.normal(slots[i]);
            out[i] = std::max(byArea(near, places[i], n),
                              m_kept.target(m_nearest.among(few, n), m_kept.supportOf(block, slots[i])));
        }
    }

  private:
    /// 0 where what faces alike is no disc.
    static float byArea(std::span<const tree::Neighbour> near, const base::Vec3f& x, const base::Vec3f& n) {
        float count = 0, farthestSq = 0;
        base::Vec3f sum;
        for (const tree::Neighbour& each : near) { // from near to far
            if (each.distanceSq == 0 || dot(each.block->normal(each.slot), n) < 0)
                continue;
            ++count, farthestSq = each.distanceSq;
            sum += each.block->position(each.slot) - x;
        }
        const float most = aside * count;
        if (count < enough || dot(sum, sum) > most * most * farthestSq)
            return 0;
        return std::sqrt(std::numbers::pi_v<float> * farthestSq / (count + held));
    }

    const KeptSpacing& m_kept;
    tree::NearestTogether m_around;
    KeptSpacing::Search m_nearest;
};

void AreaSpacing::measure(std::span<const surfel::BlockPtr> blocks) {
    m_known.measure(blocks, [&] {
        return [search = Search(*this)](const surfel::SurfelBlock& block, std::span<const int> slots,
                                        std::span<float> out) mutable { search.at(block, slots, out); };
    });
}

float AreaSpacing::at(const surfel::SurfelBlock& block, int slot) const {
    if (const float* const known = m_known.find(block, slot))
        return *known;
    float out = 0;
    Search(*this).at(block, {&slot, 1}, {&out, 1});
    return out;
}

} // namespace sculpt
