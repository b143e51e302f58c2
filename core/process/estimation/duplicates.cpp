#include "core/process/estimation/duplicates.h"

#include "core/base/box.h"
#include "core/base/disjoint_sets.h"
#include "core/base/unit_normal.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace process {

namespace {

using base::Vec3f;

/// Of the spacing around them: what stands closer is one place.
constexpr float duplicateReach = 1e-3f;
/// Neighbours that are looked at, and those of them that the spacing around a pile is made of.
constexpr std::size_t looked = 12, ring = 6;
/// Piles of so many positions leave too few of those neighbours outside of themselves: they are sought as gaps.
constexpr std::size_t leastPile = looked - ring;
/// Piles larger than this may be a small model among strays.
constexpr std::size_t doubtfulPile = 64;
/// A pile's box is at most this part of the box that holds it and something else: far less than it must be in the end.
constexpr float suspicious = 1.0f / 64;
/// Boxes are cut here rather than in their middle, where symmetric models have piles.
constexpr float cutAt = 0.4375f;
/// As with outliers (supports.cpp): a place that much sparser than those around it tells of no spacing.
constexpr float sparsest = 3;

/// Positions of a range of some order, and how far they reach.
struct Pile {
    std::uint32_t begin = 0, end = 0;
    float extent = 0;
    std::size_t size() const { return end - begin; }
};

/// Positions in an order in which every pile is a range: halved again and again by the boxes that they fill.
class Piles {
  public:
    explicit Piles(std::span<const Vec3f> positions) : m_positions(positions), m_order(positions.size()) {
        std::iota(m_order.begin(), m_order.end(), 0u);
    }
    std::span<const std::uint32_t> members(const Pile& pile) const {
        return std::span(m_order).subspan(pile.begin, pile.size());
    }
    /// Ranges inside this one that are small beside what is around them.
    void find(const Pile& within, const base::Progress& progress, std::vector<Pile>& out) {
        m_open = {within};
        for (std::size_t step = 0; !m_open.empty(); ++step) {
            if (step % 4096 == 0)
                progress.step(0, "Looking for duplicates");
            const Pile each = m_open.back();
            m_open.pop_back();
            cut(each, out);
        }
    }

  private:
    base::Box3f boxOf(const Pile& pile) const {
        base::Box3f box;
        for (const std::uint32_t i : members(pile))
            box.extend(m_positions[i]);
        return box;
    }
    /// `extent` of what comes in is that of the larger range.
    void cut(Pile each, std::vector<Pile>& out) {
        if (each.size() < leastPile)
            return;
        const base::Box3f box = boxOf(each);
        const Vec3f size = box.size();
        const float outer = std::exchange(each.extent, length(size));
        if (each.extent <= suspicious * outer) {
            out.push_back(each);
            return;
        }
        const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const float at = box.lo[axis] + cutAt * size[axis];
        const auto first = m_order.begin() + each.begin, last = m_order.begin() + each.end;
        const auto middle = std::partition(first, last, [&](std::uint32_t i) { return m_positions[i][axis] <= at; });
        const auto half = static_cast<std::uint32_t>(middle - m_order.begin());
        if (half == each.begin || half == each.end)
            return; // as close as floats can be
        m_open.push_back({each.begin, half, each.extent});
        m_open.push_back({half, each.end, each.extent});
    }

    std::span<const Vec3f> m_positions;
    std::vector<std::uint32_t> m_order;
    std::vector<Pile> m_open;
};

/// The spacing that the ring behind the nearest `skipped` neighbours tells of; 0 where there are too few.
float spacingBehind(const Neighbours& near, std::size_t skipped) {
    if (near.size() < skipped + ring)
        return 0;
    return spacingFromRing(std::span(near.distanceSq).subspan(skipped, ring));
}

/// How many of its nearest are one place with a position: those that leave a gap to the ring behind them.
std::size_t duplicatesBeside(const Neighbours& near) {
    const float farthest = near.distanceSq.empty() ? 0 : near.distanceSq.back();
    if (!(std::sqrt(near.distanceSq.front()) <= duplicateReach * std::sqrt(farthest)))
        return 0;
    for (std::size_t n = std::min(leastPile, near.size()); n > 0; --n)
        if (std::sqrt(near.distanceSq[n - 1]) <= duplicateReach * spacingBehind(near, n))
            return n;
    return 0;
}

/// What is one place with what.
class Places {
  public:
    explicit Places(std::span<const Vec3f> positions) : m_positions(positions), m_sets(positions.size()) {}

    void joinPiles(const base::Progress& progress);
    /// Those around `cloud`'s positions, which are the places `numbers`.
    void joinNeighbours(const Cloud& cloud, std::span<const std::uint32_t> numbers, const base::Progress& progress);
    /// One position of each set, and its number.
    std::vector<surfel::Surfel> reduced(std::vector<std::uint32_t>& numbers);
    std::uint32_t find(std::uint32_t place) { return m_sets.find(place); }
    bool joined() const { return m_joined; }

  private:
    void join(std::span<const std::uint32_t> members) {
        for (const std::uint32_t i : members)
            m_joined |= m_sets.join(members.front(), i);
    }
    std::vector<Pile> joinDeserving(const std::vector<Pile>& piles, const Piles& order);
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
    const float spacing = spacingBehind(near, inside);
    if (!(extent <= duplicateReach * spacing))
        return false;
    std::vector<float> others;
    for (const std::uint32_t i : near.index) {
        around.nearest(i, ring, further);
        others.push_back(spacingBehind(further, 0));
    }
    std::nth_element(others.begin(), others.begin() + looked / 2, others.end());
    return spacing <= sparsest * others[looked / 2];
}

/// Makes one place of each pile that deserves it and returns the others.
std::vector<Pile> Places::joinDeserving(const std::vector<Pile>& piles, const Piles& order) {
    Places trial = *this;
    for (const Pile& pile : piles)
        trial.join(order.members(pile));
    std::vector<std::uint32_t> numbers;
    const std::vector<surfel::Surfel> left = trial.reduced(numbers);
    const Cloud around(left);
    if (around.size() <= looked)
        return piles; // nothing to compare with
    std::vector<Pile> out, wanted;
    std::size_t doubtful = 0, outside = m_positions.size();
    for (const Pile& pile : piles) {
        const auto at = std::lower_bound(numbers.begin(), numbers.end(), trial.find(order.members(pile).front()));
        const std::uint32_t place = around.places()[static_cast<std::size_t>(at - numbers.begin())];
        const bool stands = standsAmong(around, place, pile.extent);
        (stands ? wanted : out).push_back(pile);
        outside -= pile.size();
        doubtful += stands && pile.size() > doubtfulPile ? pile.size() : 0;
    }
    const bool trusted = doubtful <= outside; // else they are the model, and the rest strays
    for (const Pile& pile : wanted)
        if (trusted || pile.size() <= doubtfulPile)
            join(order.members(pile));
        else
            out.push_back(pile);
    return out;
}

void Places::joinPiles(const base::Progress& progress) {
    Piles order(m_positions);
    std::vector<Pile> open{{0, static_cast<std::uint32_t>(m_positions.size()), 0}};
    constexpr int mostRounds = 4; // each a thousand times finer than the one before
    for (int round = 0; round < mostRounds && !open.empty(); ++round) {
        std::vector<Pile> found;
        for (const Pile& each : open)
            order.find(each, progress, found);
        open = found.empty() ? found : joinDeserving(found, order);
    }
}

void Places::joinNeighbours(const Cloud& cloud, std::span<const std::uint32_t> numbers,
                            const base::Progress& progress) {
    if (cloud.size() <= ring)
        return;
    std::vector<std::uint8_t> count(cloud.size());
    cloud.forEach(looked, progress, "Looking for duplicates", [&](std::size_t i, const Neighbours& near) {
        count[i] = static_cast<std::uint8_t>(duplicatesBeside(near));
    });
    Neighbours near;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (count[i] == 0)
            continue;
        cloud.nearest(i, count[i], near);
        for (const std::uint32_t j : near.index)
            m_joined |= m_sets.join(numbers[i], numbers[j]);
    }
}

/// `first` where the sum of unit normals has no direction, or that of the first.
Vec3f meanNormal(const Vec3f& first, const Vec3f& sum) {
    const Vec3f mean = normalized(sum);
    return length(sum) < 0.1f || dot(mean, first) > 1 - base::unitTolerance ? first : mean;
}

} // namespace

std::vector<std::uint32_t> firstOfDuplicates(const Cloud& cloud, const base::Progress& progress) {
    Places places(cloud.positions());
    places.joinPiles(part(progress, 0, 0.3));
    std::vector<std::uint32_t> left;
    const std::vector<surfel::Surfel> positions = places.reduced(left);
    if (places.joined()) {
        const Cloud reduced(positions);
        std::vector<std::uint32_t> numbers(left.size());
        for (std::size_t k = 0; k < left.size(); ++k)
            numbers[reduced.places()[k]] = left[k];
        places.joinNeighbours(reduced, numbers, part(progress, 0.3, 1));
    } else {
        places.joinNeighbours(cloud, left, part(progress, 0.3, 1));
    }
    constexpr std::uint32_t none = ~std::uint32_t(0);
    std::vector<std::uint32_t> firstAt(cloud.size(), none), out(cloud.places().size());
    for (std::uint32_t i = 0; i < out.size(); ++i) {
        std::uint32_t& first = firstAt[places.find(cloud.places()[i])];
        first = std::min(first, i);
        out[i] = first;
    }
    return out;
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
