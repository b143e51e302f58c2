#include "core/sculpt/kept_spacing.h"

#include "core/base/clones.h"
#include "core/process/estimation/spacing.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/resample.h"

#include <algorithm>
#include <array>
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
static float spacingFromDisc(std::span<const float> distancesSq, float chance) {
    const float held = static_cast<float>(distancesSq.size()) - std::lerp(0.5f, 2.0f, chance);
    return std::sqrt(std::numbers::pi_v<float> * distancesSq.back() / held);
}

namespace {

constexpr std::size_t laneCount = 16;
static_assert(KeptSpacing::Search::asked <= laneCount);

/// Some places, in lanes.
struct Places {
    alignas(64) float x[laneCount] = {}, y[laneCount] = {}, z[laneCount] = {};
    std::size_t count = 0;

    void add(const base::Vec3f& p) { x[count] = p.x, y[count] = p.y, z[count++] = p.z; }
};

/// The least squared distance between two of these.
POINTCLAY_CLONES
float closestSq(const Places& of) {
    float least[laneCount];
    for (float& each : least)
        each = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i + 1 < of.count; ++i) {
        const float px = of.x[i], py = of.y[i], pz = of.z[i];
        for (std::size_t k = 0; k < laneCount; ++k) {
            const float dx = px - of.x[k], dy = py - of.y[k], dz = pz - of.z[k];
            const float sq = dx * dx + dy * dy + dz * dz;
            const bool behind = k > i && k < of.count;
            least[k] = behind && sq < least[k] ? sq : least[k];
        }
    }
    float out = least[0];
    for (const float each : least)
        out = each < out ? each : out;
    return out;
}

} // namespace

KeptSpacing::Search::Search(const KeptSpacing& kept) : m_kept(kept), m_around(kept.first().tree(), asked) {}

void KeptSpacing::Search::at(const surfel::SurfelBlock& block, std::span<const int> slots,
                             std::span<LocalSpacing> out) {
    std::array<base::Vec3f, surfel::clusterSize> places;
    for (std::size_t i = 0; i < slots.size(); ++i)
        places[i] = block.position(slots[i]);
    m_around.at(std::span(places).first(slots.size()));
    for (std::size_t i = 0; i < slots.size(); ++i)
        out[i] = among(m_around.of(i), block.normal(slots[i]));
}

LocalSpacing KeptSpacing::Search::among(std::span<const tree::Neighbour> near, const base::Vec3f& n) const {
    std::array<float, asked> alike, all; // squared distances
    Places places;                       // of those that are alike
    float least = std::numeric_limits<float>::infinity(), most = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
        const tree::Neighbour& each = near[i];
        all[i] = each.distanceSq;
        const float support = m_kept.supportOf(*each.block, each.slot);
        least = std::min(least, support), most = std::max(most, support);
        if (dot(each.block->normal(each.slot), n) >= 0)
            alike[places.count] = each.distanceSq, places.add(each.block->position(each.slot));
    }
    constexpr std::size_t ring = 7; // with itself
    const std::span<const float> of =
        places.count < ring ? std::span(all).first(near.size()) : std::span(alike).first(places.count);
    const bool same = most < steady * least, fewer = of.size() < ring;
    const float value = same || fewer ? process::spacingFromRing(of) : spacingFromDisc(of, 0);
    const float apart = std::sqrt(closestSq(places)) / value;
    const bool even = !(apart < byChance);
    if (even || fewer)
        return {true, same, even, value};
    const float chance = std::min((byChance - apart) / (byChance - byNothingElse), 1.0f);
    return {true, same, false, spacingFromDisc(of, chance)};
}

void KeptSpacing::measure(std::span<const surfel::BlockPtr> blocks) {
    m_known.measure(blocks, [&] {
        return [search = Search(*this)](const surfel::SurfelBlock& block, std::span<const int> slots,
                                        std::span<LocalSpacing> out) mutable { search.at(block, slots, out); };
    });
}

void KeptSpacing::measured(const surfel::SurfelBlock& origin, std::span<const int> slots, Search& search,
                           std::span<LocalSpacing> out) const {
    if (const LocalSpacing* const known = m_known.find(origin, 0))
        for (std::size_t i = 0; i < slots.size(); ++i)
            out[i] = known[slots[i]];
    else
        search.at(origin, slots, out);
}

LocalSpacing KeptSpacing::measured(const surfel::SurfelBlock& origin, int slot) const {
    if (const LocalSpacing* const known = m_known.find(origin, slot))
        return *known;
    LocalSpacing out;
    Search(*this).at(origin, {&slot, 1}, {&out, 1});
    return out;
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
