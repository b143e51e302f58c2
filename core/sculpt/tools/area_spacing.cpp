#include "core/sculpt/tools/area_spacing.h"

#include "core/tree/nearest_sequence.h"

#include <algorithm>
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

    float at(const surfel::SurfelBlock& block, int slot) {
        const base::Vec3f x = block.position(slot), n = block.normal(slot);
        m_around.at(x, m_near);
        const std::span few = std::span(m_near).first(std::min(m_near.size(), KeptSpacing::Search::asked));
        return std::max(byArea(x, n), m_kept.target(m_nearest.among(few, n), m_kept.supportOf(block, slot)));
    }

  private:
    /// 0 where what faces alike is no disc.
    float byArea(const base::Vec3f& x, const base::Vec3f& n) const {
        float count = 0, farthestSq = 0;
        base::Vec3f sum;
        for (const tree::Neighbour& each : m_near) { // from near to far
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
    tree::NearestSequence m_around;
    KeptSpacing::Search m_nearest;
    std::vector<tree::Neighbour> m_near;
};

void AreaSpacing::measure(std::span<const surfel::BlockPtr> blocks) {
    m_known.measure(blocks, [&] {
        return [search = Search(*this)](const surfel::SurfelBlock& block, int slot) mutable {
            return search.at(block, slot);
        };
    });
}

float AreaSpacing::at(const surfel::SurfelBlock& block, int slot) const {
    const float* const known = m_known.find(block, slot);
    return known ? *known : Search(*this).at(block, slot);
}

} // namespace sculpt
