#include "core/sculpt/kept_spacing.h"

#include "core/process/estimation/spacing.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sculpt {

/// Farthest that what the supports are made for may be from what is there.
constexpr float band = 1.25f;
/// Supports count as made for the spacing where the two agree so far on the whole.
constexpr float agreement = 1.15f;
/// Supports that differ by no more are alike.
constexpr float steady = 1.2f;
/// Two surfels that are this part of the spacing apart at most lie there by chance: what was resampled has none. With a
/// pair so close among its nearest, a surfel has neighbours that nothing but chance has placed.
constexpr float byChance = 0.6f, byNothingElse = 0.2f;

static float typicalRatio(const surface::Surface& surface) {
    std::vector<float> ratios;
    for (const process::SpacingSample& each : process::sampleSpacing(surface.tree()))
        if (each.spacing > 0 && each.support > 0)
            ratios.push_back(each.spacing / process::spacingOf(surface.definition(), each.support));
    return ratios.empty() ? 1.0f : process::summarise(std::move(ratios)).median;
}

KeptSpacing::KeptSpacing(surface::Surface first, float atContact)
    : m_first(std::move(first)), m_atContact(atContact), m_shape(surfel::shapeChannel(*m_first->tree().layout())),
      m_same(m_first->definition().support > 0) {
    if (m_same)
        return;
    const float ratio = typicalRatio(*m_first);
    const bool agree = ratio < agreement && ratio * agreement > 1;
    m_ratio = agree ? 1 : ratio, m_typical = agree ? ratio : 1;
}

/// s^2 is the area of a surfel: that of the disc out to the farthest, over those that it holds. Of those told, the
/// surfel in the middle among them, that is half of one less where they lie evenly, with the farthest on its rim, and
/// two less where they lie by chance. `chance`: between 0 and 1.
static float spacingFromDisc(const std::vector<float>& distancesSq, float chance) {
    const float held = static_cast<float>(distancesSq.size()) - std::lerp(0.5f, 2.0f, chance);
    return std::sqrt(std::numbers::pi_v<float> * distancesSq.back() / held);
}

/// The least distance between two of these.
static float closest(const std::vector<base::Vec3f>& places) {
    float sq = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = i + 1; k < places.size(); ++k)
            sq = std::min(sq, distanceSq(places[i], places[k]));
    return std::sqrt(sq);
}

KeptSpacing::Search::Search(const KeptSpacing& kept) : m_kept(kept), m_around(kept.first().tree(), asked) {}

LocalSpacing KeptSpacing::Search::at(const base::Vec3f& x, const base::Vec3f& n) {
    m_around.at(x, m_near);
    return among(m_near, n);
}

LocalSpacing KeptSpacing::Search::among(std::span<const tree::Neighbour> near, const base::Vec3f& n) {
    m_alike.clear(), m_all.clear(), m_places.clear();
    float least = std::numeric_limits<float>::infinity(), most = 0;
    for (const tree::Neighbour& each : near) {
        m_all.push_back(each.distanceSq);
        const float support = m_kept.supportOf(*each.block, each.slot);
        least = std::min(least, support), most = std::max(most, support);
        if (dot(each.block->normal(each.slot), n) >= 0)
            m_alike.push_back(each.distanceSq), m_places.push_back(each.block->position(each.slot));
    }
    constexpr std::size_t ring = 7; // with itself
    const std::vector<float>& of = m_alike.size() < ring ? m_all : m_alike;
    const bool same = most < steady * least, fewer = of.size() < ring;
    const float value = same || fewer ? process::spacingFromRing(of) : spacingFromDisc(of, 0);
    const float apart = closest(m_places) / value;
    const bool even = !(apart < byChance);
    if (even || fewer)
        return {true, same, even, value};
    const float chance = std::min((byChance - apart) / (byChance - byNothingElse), 1.0f);
    return {true, same, false, spacingFromDisc(of, chance)};
}

void KeptSpacing::measure(std::span<const surfel::BlockPtr> blocks) {
    m_known.measure(blocks, [&] {
        return [search = Search(*this)](const surfel::SurfelBlock& block, int slot) mutable {
            return search.at(block.position(slot), block.normal(slot));
        };
    });
}

LocalSpacing KeptSpacing::measured(const surfel::SurfelBlock& origin, int slot, Search& search) const {
    const LocalSpacing* const known = m_known.find(origin, slot);
    return known ? *known : search.at(origin.position(slot), origin.normal(slot));
}

LocalSpacing KeptSpacing::measured(const surfel::SurfelBlock& origin, int slot) const {
    if (const LocalSpacing* const known = m_known.find(origin, slot))
        return *known;
    return Search(*this).at(origin.position(slot), origin.normal(slot));
}

float KeptSpacing::madeFor(float support) const {
    return m_same ? m_atContact : m_ratio * process::spacingOf(m_first->definition(), support);
}

float KeptSpacing::target(const LocalSpacing& measured, float support) const {
    const float m = measured.value;
    if (!(m > 0))
        return madeFor(support);
    return measured.steady ? std::clamp(madeFor(support), m / band, m * band) : m;
}

} // namespace sculpt
