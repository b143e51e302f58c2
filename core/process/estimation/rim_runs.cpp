#include "core/process/estimation/rim_runs.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/process/estimation/closed_rims.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace process {

namespace {

/// Over random solids of thin walls, 1000 to 13,000 surfels large, runs that seem open have up to 4 members; those at
/// narrow necks have 12, at other rims 15 and more. The longest run by chance grows with the logarithm of how many
/// could be part of one [Erdos70]: what a model of `plainSize` needs it needs ten times as large once more.
constexpr double plainRun = 8, plainSize = 1000;
constexpr std::size_t wholeOfFew = 8, fewest = 3;
constexpr double reach = 0.7;              ///< of h: neighbours, 2.4 spacings
constexpr std::size_t mostNeighbours = 32; ///< within that, where spacings are even 19
constexpr std::size_t perRound = 3;        ///< surfels by which growing makes a run longer at least, both ways
constexpr std::size_t seedsAtOnce = 32;

/// A surfel at what looks like a rim for the loosest limit.
struct Candidate {
    RimSample sample;
    surface::BoundaryPoint rim;
    std::vector<RimPlace> near; ///< surfels within reach
    bool open = true;
};

std::size_t leastRun(std::size_t surfels) {
    const double larger = std::max(1.0, static_cast<double>(surfels) / plainSize);
    return std::clamp<std::size_t>(surfels / wholeOfFew, fewest,
                                   static_cast<std::size_t>(std::lround(plainRun * (1 + std::log10(larger)))));
}

class RimRuns {
  public:
    /// `closed` null: all that looks like a rim is one.
    RimRuns(const surface::Surface& surface, const ClosedRims* closed, const base::Progress& progress)
        : m_surface(surface), m_loose(loosened(surface)), m_closed(closed), m_least(leastRun(surface.tree().size())),
          m_progress(progress) {}

    bool find(std::span<const RimSample> samples) {
        add(samples);
        std::vector<std::uint32_t> seeds(m_candidates.size());
        std::iota(seeds.begin(), seeds.end(), 0u);
        std::erase_if(seeds, [&](std::uint32_t i) { return !m_candidates[i].open; });
        if (samples.size() == m_surface.tree().size())
            return decide();
        // Seeds far from each other first: one rim is enough.
        const std::size_t packets = base::chunkCount(seeds.size(), seedsAtOnce);
        std::size_t due = 0; // candidates: looking at all of them takes a few times what looking at the last does
        for (std::size_t packet = 0; packet < packets; ++packet) {
            m_progress.step(static_cast<double>(packet) / static_cast<double>(packets), "Looking for boundaries");
            std::vector<std::uint32_t> front;
            for (std::size_t i = packet; i < seeds.size(); i += packets)
                front.push_back(seeds[i]);
            for (std::size_t round = 0; perRound * round < m_least && !front.empty(); ++round)
                front = grow(front);
            if (m_candidates.size() < due && packet + 1 < packets)
                continue;
            if (decide())
                return true;
            due = m_candidates.size() + m_candidates.size() / 4;
        }
        return false;
    }

  private:
    static constexpr std::uint32_t none = ~0u;

    void add(std::span<const RimSample> samples) {
        std::vector<std::optional<Candidate>> found(samples.size());
        base::parallelFor(samples.size(), 64, [&](std::size_t i) {
            const surface::BoundarySearch rim = rimBeside(m_loose, samples[i]);
            if (rim.ok())
                found[i] = candidateAt(samples[i], rim.point);
        });
        for (std::size_t i = 0; i < samples.size(); ++i) {
            m_known[samples[i].at.key] = found[i] ? static_cast<std::uint32_t>(m_candidates.size()) : none;
            if (found[i])
                m_candidates.push_back(std::move(*found[i]));
        }
    }

    Candidate candidateAt(const RimSample& sample, const surface::BoundaryPoint& rim) const {
        Candidate out{sample, rim, {}, true};
        const base::Vec3d foot = base::cast<double>(sample.foot), normal = base::cast<double>(sample.normal);
        if (m_closed)
            out.open = !m_closed->closedAt(rim, foot, normal);
        std::vector<tree::Neighbour> near;
        m_surface.tree().nearest(sample.foot, mostNeighbours, near, static_cast<float>(reach * rim.unit));
        for (const tree::Neighbour& each : near)
            out.near.push_back({rimKey(each.blockNumber, each.slot), each.block->position(each.slot)});
        return out;
    }

    /// Looks at what stands around the open ones among these candidates; returns those that it finds.
    std::vector<std::uint32_t> grow(const std::vector<std::uint32_t>& front) {
        std::vector<RimPlace> places;
        for (const std::uint32_t i : front)
            for (const RimPlace& each : m_candidates[i].near)
                if (m_candidates[i].open && !m_known.contains(each.key))
                    places.push_back(each);
        std::sort(places.begin(), places.end(), [](const RimPlace& a, const RimPlace& b) { return a.key < b.key; });
        places.erase(std::unique(places.begin(), places.end(),
                                 [](const RimPlace& a, const RimPlace& b) { return a.key == b.key; }),
                     places.end());
        const auto before = static_cast<std::uint32_t>(m_candidates.size());
        add(lookAt(m_surface, places, {{}, m_progress.cancel}));
        std::vector<std::uint32_t> out(m_candidates.size() - before);
        std::iota(out.begin(), out.end(), before);
        return out;
    }

    template <class Fn>
    void forNeighbours(std::uint32_t i, const Fn& fn) const {
        const bool oriented = m_surface.tree().layout()->oriented;
        for (const RimPlace& each : m_candidates[i].near) {
            const auto found = m_known.find(each.key);
            if (found == m_known.end() || found->second == none || found->second == i)
                continue;
            const float alike = dot(m_candidates[found->second].sample.normal, m_candidates[i].sample.normal);
            if (!oriented || alike > 0) // not those of the other side of a wall
                fn(found->second);
        }
    }

    /// Whether there is a run that is long enough, of those that have open ones beside them only.
    bool decide() const {
        const auto count = static_cast<std::uint32_t>(m_candidates.size());
        std::vector<std::uint8_t> pure(count);
        base::parallelFor(count, 64, [&](std::size_t i) {
            pure[i] = m_candidates[i].open;
            forNeighbours(static_cast<std::uint32_t>(i), [&](std::uint32_t j) { pure[i] &= m_candidates[j].open; });
        });
        base::DisjointSets runs(count);
        std::vector<std::size_t> size(count);
        for (std::uint32_t i = 0; i < count; ++i)
            if (pure[i])
                forNeighbours(i, [&](std::uint32_t j) {
                    if (pure[j])
                        runs.join(i, j);
                });
        for (std::uint32_t i = 0; i < count; ++i)
            size[runs.find(i)] += pure[i];
        return std::any_of(size.begin(), size.end(), [&](std::size_t n) { return n >= m_least; });
    }

    const surface::Surface& m_surface;
    surface::Surface m_loose;
    const ClosedRims* m_closed;
    std::size_t m_least;
    base::Progress m_progress;
    std::vector<Candidate> m_candidates;
    std::unordered_map<std::uint32_t, std::uint32_t> m_known; ///< by key: number of the candidate, or none
};

} // namespace

bool hasOpenRun(const surface::Surface& surface, std::span<const RimSample> samples, const base::Progress& progress) {
    if (!RimRuns(surface, nullptr, part(progress, 0, 0.5)).find(samples)) // what has no run needs no winding numbers
        return false;
    if (!surface.tree().layout()->oriented)
        return true;
    const ClosedRims closed(surface, part(progress, 0.5, 0.7));
    return RimRuns(surface, &closed, part(progress, 0.7, 1)).find(samples);
}

} // namespace process
