#include "core/reduce/coverage.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/weights.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

namespace reduce {

namespace {

constexpr int fewest = 5;            ///< supports over a place
constexpr float leastWeight = 0.35f; ///< and their weights together
/// A place that is missed under more supports than these has enough of them; what is over it gives way.
constexpr int enoughToMend = 10;
constexpr float givenWay = 0.92f;
constexpr float growth = 1.25f; ///< most in a round
constexpr int rounds = 12;
constexpr float mostGrowth = 3; ///< in all
/// Where two sheets are put together as solids, each is summed on supports of this part (surface/README 2.7).
constexpr float partSupport = 0.75f;
constexpr float opposite = -0.3f, leastFacing = 0.17f;
constexpr float shareOfOpposite = 0.02f;
constexpr std::size_t asked = 12;

struct Wish {
    std::uint32_t site;
    float factor;
};

class Coverage {
  public:
    Coverage(std::span<const base::Vec3f> places, std::span<const base::Vec3f> normals, bool oriented, Sites& sites)
        : m_places(places), m_normals(normals), m_oriented(oriented), m_sites(sites), m_tree(treeOf(sites)) {}

    /// What one thread looks with.
    struct Scratch {
        std::vector<std::pair<std::uint32_t, float>> over; ///< sites above a place; squared distances
        std::vector<tree::Neighbour> near;
    };

    /// What a place lacks, as wishes; true where it lacks something.
    bool look(std::uint32_t place, Scratch& scratch, std::vector<Wish>& wishes) const {
        scratch.over.clear();
        m_tree.forSupporting(m_places[place], [&](std::uint32_t k, float distanceSq) {
            scratch.over.push_back({k, distanceSq});
        });
        const float scale = scaleOf(place, scratch);
        int count = 0;
        float weight = 0;
        for (const auto& [k, distanceSq] : scratch.over) {
            const float h = scale * m_sites.support[k];
            if (facing(place, k) && distanceSq < h * h)
                ++count, weight += surface::wendlandC2(std::sqrt(distanceSq) / h);
        }
        if (count >= fewest && weight >= leastWeight)
            return false;
        wish(place, scale, count < fewest ? fewest - count : 2, count < fewest, scratch.near, wishes);
        return true;
    }
    /// The nearest in their own metric, `wanted` of them; of those that do not reach the place alone, where so asked.
    void wish(std::uint32_t place, float scale, int wanted, bool outsideOnly, std::vector<tree::Neighbour>& near,
              std::vector<Wish>& wishes) const {
        m_tree.tree().nearest(m_places[place], asked, near);
        std::vector<Wish> all;
        for (const tree::Neighbour& n : near) {
            const std::uint32_t k = NumberedTree::number(n);
            const float distanceSq = m_sites.shape.empty()
                                         ? n.distanceSq
                                         : surfel::shapedSq(m_places[place] - m_sites.position[k], m_sites.shape[k]);
            const float lacking = std::sqrt(distanceSq) / (scale * m_sites.support[k]);
            if (facing(place, k) && !(outsideOnly && lacking < 1))
                all.push_back({k, lacking});
        }
        std::stable_sort(all.begin(), all.end(), [](const Wish& a, const Wish& b) { return a.factor < b.factor; });
        for (std::size_t k = 0; k < all.size() && k < static_cast<std::size_t>(wanted); ++k)
            wishes.push_back({all[k].site, std::min(growth, std::max(1.1f, 1.02f * all[k].factor))});
    }

  private:
    static NumberedTree treeOf(const Sites& sites) {
        return {sites.position, sites.normal, sites.support, sites.shape};
    }
    bool facing(std::uint32_t place, std::uint32_t site) const {
        const float c = dot(m_normals[place], m_sites.normal[site]);
        return (m_oriented ? c : std::abs(c)) > leastFacing;
    }
    /// Which part of the supports counts: less where another sheet is within reach.
    float scaleOf(std::uint32_t place, const Scratch& scratch) const {
        if (!m_oriented)
            return 1;
        float all = 0, against = 0;
        for (const auto& [k, distanceSq] : scratch.over) {
            const float w = surface::wendlandC2(std::sqrt(distanceSq) / m_sites.support[k]);
            all += w;
            if (dot(m_normals[place], m_sites.normal[k]) < opposite)
                against += w;
        }
        return against > shareOfOpposite * all ? partSupport : 1;
    }

    std::span<const base::Vec3f> m_places, m_normals;
    bool m_oriented;
    const Sites& m_sites;
    NumberedTree m_tree;
};

/// Every site grows as the most urgent wish says. False where none may grow any more.
bool grow(const std::vector<std::vector<Wish>>& wishes, std::span<const float> first, Sites& sites) {
    std::vector<float> factor(sites.size(), 1);
    for (const std::vector<Wish>& part : wishes)
        for (const Wish& wish : part)
            factor[wish.site] = std::max(factor[wish.site], wish.factor);
    bool any = false;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const float grown = std::min(sites.support[i] * factor[i], std::max(sites.support[i], mostGrowth * first[i]));
        any |= grown > sites.support[i];
        sites.support[i] = grown;
    }
    return any;
}

} // namespace

void cover(const Places& places, float supports, Sites& sites) {
    constexpr std::size_t grain = 512;
    sites.support.resize(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i)
        sites.support[i] = sites.spacing[i] * std::sqrt(supports / std::numbers::pi_v<float>) *
                           std::sqrt(surfel::aspectOf(sites.shapeAt(i)));
    const std::vector<float> first = sites.support;
    std::vector<std::uint32_t> open(places.size());
    std::iota(open.begin(), open.end(), 0u);
    for (int round = 0; round < rounds && !open.empty(); ++round) {
        const Coverage coverage(places.position, places.normal, places.oriented, sites);
        std::vector<std::vector<Wish>> wishes(base::chunkCount(open.size(), grain));
        std::vector<std::vector<std::uint32_t>> left(wishes.size());
        base::parallelChunks(open.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            Coverage::Scratch scratch;
            for (std::size_t k = begin; k < end; ++k)
                if (coverage.look(open[k], scratch, wishes[chunk]))
                    left[chunk].push_back(open[k]);
        });
        open.clear();
        for (const auto& part : left)
            open.insert(open.end(), part.begin(), part.end());
        if (!grow(wishes, first, sites))
            break;
    }
}

bool mendAround(std::span<const base::Vec3f> missed, std::span<const base::Vec3f> normals,
                std::span<const int> supports, bool oriented, Sites& sites) {
    const Coverage coverage(missed, normals, oriented, sites);
    std::vector<std::vector<Wish>> wishes(1);
    std::vector<Wish> tooMany;
    std::vector<tree::Neighbour> near;
    for (std::uint32_t i = 0; i < missed.size(); ++i)
        coverage.wish(i, 1, 4, false, near, supports[i] > enoughToMend ? tooMany : wishes.front());
    std::vector<std::uint8_t> grows(sites.size());
    for (const Wish& wish : wishes.front())
        grows[wish.site] = 1;
    bool any = grow(wishes, sites.support, sites);
    for (const Wish& wish : tooMany)
        if (!std::exchange(grows[wish.site], std::uint8_t(1)))
            sites.support[wish.site] *= givenWay, any = true;
    return any;
}

} // namespace reduce
