#include "core/reduce/placement.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/reduce/density.h"
#include "core/reduce/watch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

namespace reduce {

namespace {

constexpr int rounds = 15;
constexpr std::size_t asked = 20; ///< neighbours of a site, of any sheet
constexpr float leastFacing = -0.1f;
constexpr std::size_t grain = 1024;
/// Darts end at some 0.83 spacings where they lie as close as chance packs them.
constexpr float widestApart = 0.92f, shrink = 0.95f, leastApart = 0.02f;

class Relaxation {
  public:
    Relaxation(const Places& places, const NumberedTree& tree, std::span<const float> shares, std::size_t count)
        : m_places(places), m_shares(shares), m_owner(places.size()), m_member(places.size()) {
        start(tree, count);
    }
    Sites& sites() { return m_sites; }

    void round() {
        findNeighbours();
        assign();
        gather();
        fillEmpty();
        centre();
    }

  private:
    using Near = std::array<std::uint32_t, asked>;
    static constexpr std::uint32_t none = ~0u;

    void take(std::size_t site, std::size_t place) {
        m_sites.position[site] = m_places.position[place];
        m_sites.normal[site] = m_places.normal[place];
        m_sites.spacing[site] = spacingAt(m_places, m_shares, place);
        if (!m_places.shape.empty())
            m_sites.shape[site] = m_places.shape[place];
    }

    /// Darts in random order, each of which keeps others off by its spacing times `apart`; the first radius is too
    /// large for `count` of them, and shrinks until there are so many [McCool92].
    void start(const NumberedTree& tree, std::size_t count) {
        m_sites.position.reserve(count), m_sites.normal.reserve(count), m_sites.spacing.reserve(count);
        std::vector<std::uint32_t> order(m_places.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [](std::uint32_t a, std::uint32_t b) {
            const std::uint64_t x = base::mix(a), y = base::mix(b);
            return x != y ? x < y : a < b;
        });
        std::vector<std::uint32_t> chosen;
        std::vector<std::uint8_t> taken(m_places.size());
        for (float apart = widestApart; chosen.size() < count; apart *= shrink) {
            std::fill(taken.begin(), taken.end(), std::uint8_t(0));
            base::parallelFor(chosen.size(), 256, [&](std::size_t k) { keepOff(tree, chosen[k], apart, taken); });
            for (std::size_t k = 0; k < order.size() && chosen.size() < count; ++k) {
                if (k % 4096 == 0)
                    base::CancelScope::check();
                if (taken[order[k]])
                    continue;
                chosen.push_back(order[k]);
                keepOff(tree, order[k], apart, taken);
            }
        }
        std::sort(chosen.begin(), chosen.end());
        m_sites.position.resize(count), m_sites.normal.resize(count), m_sites.spacing.resize(count);
        m_sites.shape.resize(m_places.shape.empty() ? 0 : count);
        for (std::size_t k = 0; k < count; ++k)
            take(k, chosen[k]);
    }
    /// Marks what the dart at a place keeps others off.
    void keepOff(const NumberedTree& tree, std::uint32_t place, float apart, std::vector<std::uint8_t>& taken) const {
        const auto mark = [&](std::uint32_t i) {
            std::atomic_ref<std::uint8_t>(taken[i]).store(1, std::memory_order_relaxed);
        };
        mark(place);
        if (apart < leastApart)
            return;
        const base::Vec3f b = m_places.shapeAt(place);
        const float reach = apart * spacingAt(m_places, m_shares, place) * std::sqrt(surfel::aspectOf(b));
        tree.forBall(m_places.position[place], reach, [&](std::uint32_t i, float) {
            if (!m_places.shape.empty() &&
                surfel::shapedSq(m_places.position[i] - m_places.position[place], b) >= reach * reach)
                return;
            if (m_places.facing(m_places.normal[place], m_places.normal[i], leastFacing))
                mark(i);
        });
    }

    /// Of each site the sites around it that face as it does, itself first.
    void findNeighbours() {
        const NumberedTree tree(m_sites.position, m_sites.normal, {});
        const bool first = m_near.empty();
        m_near.resize(m_sites.size());
        base::parallelChunks(m_sites.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<tree::Neighbour> near;
            for (std::size_t i = begin; i < end; ++i) {
                tree.tree().nearest(m_sites.position[i], asked, near);
                std::size_t at = 0;
                m_near[i].fill(none);
                m_near[i][at++] = static_cast<std::uint32_t>(i);
                for (const tree::Neighbour& n : near)
                    if (const std::uint32_t k = NumberedTree::number(n);
                        k != i && at < asked && m_places.facing(m_sites.normal[i], m_sites.normal[k], leastFacing))
                        m_near[i][at++] = k;
            }
        });
        if (first)
            ownersByDistance(tree);
    }

    void ownersByDistance(const NumberedTree& tree) {
        base::parallelChunks(m_places.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<tree::Neighbour> near;
            for (std::size_t i = begin; i < end; ++i) {
                tree.tree().nearest(m_places.position[i], 8, near);
                for (const tree::Neighbour& n : near)
                    if (const std::uint32_t k = NumberedTree::number(n);
                        m_places.facing(m_places.normal[i], m_sites.normal[k], leastFacing)) {
                        m_owner[i] = k;
                        break;
                    }
            }
        });
    }

    /// Squared, in spacings; far more along the site's normal, so that walls behind go to their own.
    float distance(std::size_t place, std::uint32_t site) const {
        const base::Vec3f q = m_places.position[place] - m_sites.position[site];
        const float s = m_sites.spacing[site] * m_sites.spacing[site];
        const float height = dot(q, m_sites.normal[site]);
        if (!m_places.shape.empty())
            return 0.5f * (spaced(q, m_sites.shape[site]) / s +
                           spaced(q, m_places.shape[place]) * m_shares[place] / m_places.area[place]) +
                   height * height / s;
        return 0.5f * lengthSq(q) * (1 / s + m_shares[place] / m_places.area[place]) + height * height / s;
    }

    /// Squared, as the shape sees it, in ellipses of the same area.
    static float spaced(const base::Vec3f& q, const base::Vec3f& b) {
        return surfel::shapedSq(q, b) / surfel::aspectOf(b);
    }

    void assign() {
        base::parallelFor(m_places.size(), grain, [&](std::size_t i) {
            std::uint32_t best = m_owner[i];
            float least = std::numeric_limits<float>::infinity();
            for (const std::uint32_t k : m_near[m_owner[i]]) {
                if (k == none)
                    break;
                if (!m_places.facing(m_places.normal[i], m_sites.normal[k], leastFacing))
                    continue;
                if (const float d = distance(i, k); d < least || (d == least && k < best))
                    least = d, best = k;
            }
            m_owner[i] = best;
        });
    }

    /// Members of each site, ascending.
    void gather() {
        m_first.assign(m_sites.size() + 1, 0);
        for (const std::uint32_t site : m_owner)
            ++m_first[site + 1];
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
        std::vector<std::uint32_t> at(m_first.begin(), m_first.end() - 1);
        for (std::size_t i = 0; i < m_owner.size(); ++i)
            m_member[at[m_owner[i]]++] = static_cast<std::uint32_t>(i);
    }
    std::span<const std::uint32_t> membersOf(std::size_t site) const {
        return std::span(m_member).subspan(m_first[site], m_first[site + 1] - m_first[site]);
    }

    /// Sites that nothing came to begin anew, at the far end of the fullest cells.
    void fillEmpty() {
        std::vector<std::uint32_t> empty, full;
        std::vector<float> load(m_sites.size(), 0);
        for (std::size_t i = 0; i < m_sites.size(); ++i) {
            for (const std::uint32_t member : membersOf(i))
                load[i] += m_shares[member];
            const std::size_t members = m_first[i + 1] - m_first[i];
            if (members == 0)
                empty.push_back(static_cast<std::uint32_t>(i));
            else if (members > 1)
                full.push_back(static_cast<std::uint32_t>(i));
        }
        const std::size_t moved = std::min(empty.size(), full.size());
        const auto fuller = [&](std::uint32_t a, std::uint32_t b) {
            return load[a] != load[b] ? load[a] > load[b] : a < b;
        };
        std::partial_sort(full.begin(), full.begin() + static_cast<std::ptrdiff_t>(moved), full.end(), fuller);
        m_kept.assign(m_sites.size(), 0);
        for (std::size_t k = 0; k < moved; ++k) {
            std::uint32_t farthest = membersOf(full[k]).front();
            for (const std::uint32_t member : membersOf(full[k]))
                if (distance(member, full[k]) > distance(farthest, full[k]))
                    farthest = member;
            take(empty[k], farthest);
            m_owner[farthest] = empty[k];
        }
        for (const std::uint32_t i : empty)
            m_kept[i] = 1;
    }

    void centre() {
        base::parallelFor(m_sites.size(), 256, [&](std::size_t site) {
            if (m_kept[site])
                return;
            const base::Vec3f from = m_sites.position[site];
            base::Vec3d sum;
            double weight = 0;
            for (const std::uint32_t i : membersOf(site)) {
                sum += base::cast<double>(m_places.position[i] - from) * double(m_shares[i]);
                weight += double(m_shares[i]);
            }
            const base::Vec3f middle = from + base::cast<float>(sum / weight);
            std::uint32_t nearest = membersOf(site).front();
            for (const std::uint32_t i : membersOf(site))
                if (distanceSq(m_places.position[i], middle) < distanceSq(m_places.position[nearest], middle))
                    nearest = i;
            take(site, nearest);
            // On the tangent plane of the nearest place: the middle itself sinks where the surface bends.
            const base::Vec3f n = m_places.normal[nearest];
            m_sites.position[site] = middle - n * dot(n, middle - m_places.position[nearest]);
        });
    }

    const Places& m_places;
    std::span<const float> m_shares;
    Sites m_sites;
    std::vector<Near> m_near;
    std::vector<std::uint32_t> m_owner, m_member;
    std::vector<std::uint32_t> m_first;
    std::vector<std::uint8_t> m_kept;
};

} // namespace

/// Onto the surface where it is near; else they stay on the tangent plane of a place.
static void land(const surface::Surface& surface, bool oriented, Sites& sites) {
    Places feet;
    feet.oriented = oriented;
    std::vector<std::uint8_t> kept;
    std::vector<float> reach = sites.spacing;
    for (float& r : reach)
        r *= 0.5f;
    appendFeet(surface, sites.position, sites.normal, reach, feet, &kept);
    for (std::size_t i = 0, foot = 0; i < sites.size(); ++i)
        if (kept[i]) {
            sites.position[i] = feet.position[foot];
            sites.normal[i] = feet.normal[foot++];
        }
}

Sites place(const surface::Surface& surface, const Places& places, NumberedTree tree, std::span<const float> shares,
            std::size_t count, const base::Progress& progress) {
    progress.step(0, "Placing samples");
    Relaxation relaxation(places, tree, shares, count);
    tree = {};
    for (int k = 0; k < rounds; ++k) {
        progress.step(double(k) / rounds, "Placing samples");
        relaxation.round();
        WatchScope::tell(relaxation.sites());
    }
    land(surface, places.oriented, relaxation.sites());
    return std::move(relaxation.sites());
}

} // namespace reduce
