#include "core/process/estimation/duplicates.h"

#include "core/base/disjoint_sets.h"
#include "core/base/ranked.h"
#include "core/base/unit_normal.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/piles.h"
#include "core/process/estimation/spacing_sample.h"

#include <algorithm>
#include <cmath>

namespace process {

namespace {

using base::Vec3f;

/// Of the spacing around them: what stands closer is one place.
constexpr float duplicateReach = 1e-3f;
/// Neighbours that are looked at, and those of them that the spacing around a pile is made of.
constexpr std::size_t looked = 12, ring = 6;
static_assert(leastPile == looked - ring && looked == NeighbourTable::most);
/// Piles larger than this may be a small model among strays.
constexpr std::size_t doubtfulPile = 64;
/// Larger ones are not judged by the neighbours that they have before anything is joined.
constexpr std::size_t largestJudged = 256;
/// As with outliers (supports.cpp): a place that much sparser than those around it tells of no spacing.
constexpr float sparsest = 3;

/// The spacing that the ring behind the nearest `skipped` neighbours tells of; 0 where there are too few.
float spacingBehind(std::span<const float> distanceSq, std::size_t skipped) {
    if (distanceSq.size() < skipped + ring)
        return 0;
    return spacingFromRing(distanceSq.subspan(skipped, ring));
}

/// What is one place with what.
class Places {
  public:
    explicit Places(std::span<const Vec3f> positions) : m_positions(positions), m_sets(positions.size()) {}

    void joinPiles(const Cloud& cloud, std::vector<Pile> open, const base::Progress& progress);
    /// Those around `cloud`'s positions, which are the places `numbers`, or the same where there are none.
    void joinNeighbours(const CloudNeighbours& near, std::span<const std::uint32_t> numbers);
    /// One position of each set, and its number.
    std::vector<surfel::Surfel> reduced(std::vector<std::uint32_t>& numbers);
    std::uint32_t find(std::uint32_t place) { return m_sets.find(place); }
    bool joined() const { return m_joined; }

  private:
    void join(std::span<const std::uint32_t> members) {
        for (const std::uint32_t i : members)
            m_joined |= m_sets.join(members.front(), i);
    }
    bool mayDeserve(const Cloud& cloud, const std::vector<Pile>& piles) const;
    std::vector<Pile> joinDeserving(const std::vector<Pile>& piles);
    bool standsAmong(const Cloud& around, std::uint32_t place, float extent) const;

    std::span<const Vec3f> m_positions;
    base::DisjointSets m_sets;
    bool m_joined = false;
};

std::vector<surfel::Surfel> Places::reduced(std::vector<std::uint32_t>& numbers) {
    std::vector<surfel::Surfel> out;
    for (std::uint32_t i = 0; i < m_positions.size(); ++i)
        if (m_sets.find(i) == i) {
            numbers.push_back(i);
            out.emplace_back().position = m_positions[i];
        }
    return out;
}

/// Whether a pile of this extent, now one position, is small beside its neighbours, and these tell of a spacing.
bool Places::standsAmong(const Cloud& around, std::uint32_t place, float extent) const {
    Neighbours near, further;
    around.nearest(place, looked, near);
    std::size_t inside = 0;
    while (inside < near.size() && std::sqrt(near.distanceSq[inside]) <= extent)
        ++inside;
    const float spacing = spacingBehind(near.distanceSq, inside);
    if (!(extent <= duplicateReach * spacing))
        return false;
    std::vector<float> others;
    for (const std::uint32_t i : near.index) {
        around.nearest(i, ring, further);
        others.push_back(spacingBehind(further.distanceSq, 0));
    }
    return spacing <= sparsest * base::ranked(others, looked / 2);
}

/// False where no pile can stand the trial: each has, outside of all piles, enough neighbours that stay what they are
/// in it and are so near that the ring around the pile cannot be wide enough. Most models have a few groups of
/// positions that boxes make look like piles; a trial costs a search among all positions.
bool Places::mayDeserve(const Cloud& cloud, const std::vector<Pile>& piles) const {
    if (m_joined)
        return true;
    std::vector<std::uint8_t> piled(m_positions.size(), 0);
    for (const Pile& pile : piles)
        for (const std::uint32_t i : pile.members)
            piled[i] = 1;
    Neighbours near;
    return std::any_of(piles.begin(), piles.end(), [&](const Pile& pile) {
        if (pile.members.size() > largestJudged)
            return true;
        const std::uint32_t stays = *std::min_element(pile.members.begin(), pile.members.end());
        cloud.nearest(stays, 2 * (looked + pile.members.size()), near);
        std::size_t outside = 0;
        for (std::size_t k = 0; k < near.size(); ++k)
            if (!piled[near.index[k]] && ++outside == looked)
                return !(pile.extent > 1.001f * duplicateReach * std::sqrt(near.distanceSq[k]));
        return true;
    });
}

/// Makes one place of each pile that deserves it and returns the others.
std::vector<Pile> Places::joinDeserving(const std::vector<Pile>& piles) {
    Places trial = *this;
    for (const Pile& pile : piles)
        trial.join(pile.members);
    std::vector<std::uint32_t> numbers;
    const std::vector<surfel::Surfel> left = trial.reduced(numbers);
    const Cloud around(left);
    if (around.size() <= looked)
        return piles; // nothing to compare with
    std::vector<Pile> out, wanted;
    std::size_t doubtful = 0, outside = m_positions.size();
    for (const Pile& pile : piles) {
        const auto at = std::lower_bound(numbers.begin(), numbers.end(), trial.find(pile.members.front()));
        const std::uint32_t place = around.places()[static_cast<std::size_t>(at - numbers.begin())];
        const bool stands = standsAmong(around, place, pile.extent);
        (stands ? wanted : out).push_back(pile);
        outside -= pile.members.size();
        doubtful += stands && pile.members.size() > doubtfulPile ? pile.members.size() : 0;
    }
    const bool trusted = doubtful <= outside; // else they are the model, and the rest strays
    for (const Pile& pile : wanted)
        if (trusted || pile.members.size() <= doubtfulPile)
            join(pile.members);
        else
            out.push_back(pile);
    return out;
}

void Places::joinPiles(const Cloud& cloud, std::vector<Pile> open, const base::Progress& progress) {
    constexpr int mostRounds = 4; // each a thousand times finer than the one before
    for (int round = 0; round < mostRounds && !open.empty(); ++round) {
        if (mayDeserve(cloud, open))
            open = joinDeserving(open);
        std::vector<Pile> inner;
        for (const Pile& each : open)
            findPiles(m_positions, each, progress, inner);
        open = std::move(inner);
    }
}

void Places::joinNeighbours(const CloudNeighbours& near, std::span<const std::uint32_t> numbers) {
    if (near.table.size() <= ring)
        return;
    const auto number = [&](std::size_t i) { return numbers.empty() ? static_cast<std::uint32_t>(i) : numbers[i]; };
    for (std::size_t i = 0; i < near.table.size(); ++i) {
        if (near.doubles[i] == 0)
            continue;
        const NeighbourTable::Row row = near.table.row(i);
        for (std::size_t k = 0; k < near.doubles[i]; ++k)
            m_joined |= m_sets.join(number(i), number(row[k]));
    }
}

/// `first` where the sum of unit normals has no direction, or that of the first.
Vec3f meanNormal(const Vec3f& first, const Vec3f& sum) {
    const Vec3f mean = normalized(sum);
    return length(sum) < 0.1f || dot(mean, first) > 1 - base::unitTolerance ? first : mean;
}

/// The first point of the list in each place, by number where there are any.
std::vector<std::uint32_t> firstIn(Places& places, const PointPlaces& placeOf, std::size_t count,
                                   std::span<const std::uint32_t> numbers) {
    constexpr std::uint32_t none = ~std::uint32_t(0);
    std::vector<std::uint32_t> firstAt(count, none), out(placeOf.size());
    for (std::uint32_t i = 0; i < out.size(); ++i) {
        std::uint32_t& first = firstAt[places.find(placeOf[i])];
        if (first == none || (!numbers.empty() && numbers[i] < numbers[first]))
            first = i;
    }
    for (std::uint32_t i = 0; i < out.size(); ++i)
        out[i] = firstAt[places.find(placeOf[i])];
    return out;
}

} // namespace

std::size_t duplicatesBeside(std::span<const float> distanceSq) {
    if (distanceSq.empty() || !(std::sqrt(distanceSq.front()) <= duplicateReach * std::sqrt(distanceSq.back())))
        return 0;
    for (std::size_t n = std::min(leastPile, distanceSq.size()); n > 0; --n)
        if (std::sqrt(distanceSq[n - 1]) <= duplicateReach * spacingBehind(distanceSq, n))
            return n;
    return 0;
}

std::vector<std::uint32_t> firstOfDuplicates(const Cloud& cloud, const CloudNeighbours& neighbours,
                                             const base::Progress& progress, std::span<const std::uint32_t> numbers) {
    std::vector<Pile> piles = findPiles(cloud, neighbours.closestPile, progress);
    const bool none = std::all_of(neighbours.doubles.begin(), neighbours.doubles.end(),
                                  [](std::uint8_t doubles) { return doubles == 0; });
    if (piles.empty() && none && cloud.size() == cloud.places().size())
        return {};
    Places places(cloud.positions());
    places.joinPiles(cloud, std::move(piles), part(progress, 0, 0.5));
    if (places.joined()) {
        std::vector<std::uint32_t> left;
        const std::vector<surfel::Surfel> positions = places.reduced(left);
        const Cloud reduced(positions);
        std::vector<std::uint32_t> whole(left.size());
        for (std::size_t k = 0; k < left.size(); ++k)
            whole[reduced.places()[k]] = left[k];
        places.joinNeighbours(neighboursOf(reduced, 0, part(progress, 0.5, 1)), whole);
    } else {
        places.joinNeighbours(neighbours, {});
    }
    if (!places.joined() && cloud.size() == cloud.places().size())
        return {};
    return firstIn(places, cloud.places(), cloud.size(), numbers);
}

std::size_t mergeDuplicates(surfel::SurfelList& points, std::span<const std::uint32_t> first) {
    std::vector<std::pair<std::uint32_t, Vec3f>> sums; // of those that have duplicates, by number
    for (std::uint32_t i = 0; i < first.size(); ++i)
        if (first[i] != i)
            sums.push_back({first[i], {}});
    if (sums.empty())
        return 0;
    const std::size_t merged = sums.size();
    std::sort(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    sums.erase(std::unique(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
               sums.end());
    const auto sumOf = [&](std::uint32_t i) -> Vec3f& {
        return std::lower_bound(sums.begin(), sums.end(), i, [](const auto& a, std::uint32_t n) { return a.first < n; })
            ->second;
    };
    for (auto& [i, sum] : sums)
        sum = points.items[i].normal;
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        const Vec3f &normal = points.items[i].normal, &own = points.items[first[i]].normal;
        if (first[i] != i)
            sumOf(first[i]) += !points.layout->oriented && dot(normal, own) < 0 ? -normal : normal;
    }
    for (const auto& [i, sum] : sums)
        points.items[i].normal = meanNormal(points.items[i].normal, sum);
    keepPoints(points, [&](std::size_t i) { return first[i] == i; });
    return merged;
}

} // namespace process
