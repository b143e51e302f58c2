#include "core/process/registering/find_place.h"

#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>

namespace process {

using base::Vec3d;

namespace {

constexpr std::size_t tries = 400000, tasks = 64, judged = 500, keptBest = 4;
constexpr double alikeLength = 0.9; ///< shorter over longer side of the two triangles
constexpr double leastSide = 4;     ///< of the triangles, in spacings: small ones tell no direction
constexpr double nearby = 1.5;      ///< in spacings: a point has its like there

struct Match {
    std::uint32_t moving, fixed;
};

/// Points in cells, to ask whether one is near that faces the same way.
class Places {
  public:
    Places(const Features& features, double radius) : m_features(features), m_radius(radius) {
        for (std::uint32_t i = 0; i < features.position.size(); ++i)
            m_cells.at(cellAt(features.position[i])).push_back(i);
    }
    bool holds(const Vec3d& p, const Vec3d& n, bool oriented) const {
        bool found = false;
        base::forCellsAround(cellAt(p), [&](const base::Cell& cell) {
            const std::vector<std::uint32_t>* there = found ? nullptr : m_cells.find(cell);
            if (!there)
                return;
            found = std::any_of(there->begin(), there->end(), [&](std::uint32_t i) {
                const double along = dot(n, m_features.normal[i]);
                return distanceSq(p, m_features.position[i]) < m_radius * m_radius &&
                       (oriented ? along : std::abs(along)) > 0.7;
            });
        });
        return found;
    }

  private:
    base::Cell cellAt(const Vec3d& p) const { return base::cellOf(p, Vec3d{}, 1 / m_radius); }

    const Features& m_features;
    double m_radius;
    base::CellMap<std::vector<std::uint32_t>> m_cells;
};

bool sidesAgree(const Vec3d (&a)[3], const Vec3d (&b)[3], double least) {
    for (int k = 0; k < 3; ++k) {
        const double p = distance(a[k], a[(k + 1) % 3]), q = distance(b[k], b[(k + 1) % 3]);
        if (!(std::min(p, q) > least && std::min(p, q) > alikeLength * std::max(p, q)))
            return false;
    }
    return true;
}

double shareOf(const Rigid& pose, const Features& moving, const Places& places, bool oriented, std::size_t points) {
    points = std::min(points, moving.position.size());
    std::size_t found = 0;
    for (std::size_t k = 0; k < points; ++k) {
        const std::size_t i = k * moving.position.size() / points;
        found += places.holds(pose(moving.position[i]), pose.turn(moving.normal[i]), oriented);
    }
    return static_cast<double>(found) / static_cast<double>(points);
}

/// Each the best of a task's tries.
std::vector<FoundPlace> bestOfTasks(const std::vector<Match>& matches, const Features& moving, const Features& fixed,
                                    const Places& places, float spacing, bool oriented) {
    std::vector<FoundPlace> best(tasks);
    base::parallelFor(tasks, 1, [&](std::size_t task) {
        base::Random random(task);
        for (std::size_t t = 0; t < tries / tasks; ++t) {
            Vec3d a[3], b[3], na[3], nb[3];
            for (int k = 0; k < 3; ++k) {
                const Match& m = matches[random.below(matches.size())];
                a[k] = moving.position[m.moving], b[k] = fixed.position[m.fixed];
                na[k] = moving.normal[m.moving], nb[k] = fixed.normal[m.fixed];
            }
            Rigid pose;
            if (!sidesAgree(a, b, leastSide * static_cast<double>(spacing)) || !bestMotion(a, b, 3, pose))
                continue;
            const auto faces = [&](int k) {
                const double along = dot(pose.turn(na[k]), nb[k]);
                return (oriented ? along : std::abs(along)) > 0.5;
            };
            if (!faces(0) || !faces(1) || !faces(2))
                continue;
            // few points rule most of them out
            if (shareOf(pose, moving, places, oriented, 40) < 0.8 * best[task].share)
                continue;
            if (const double share = shareOf(pose, moving, places, oriented, judged); share > best[task].share)
                best[task] = {pose, share};
        }
    });
    return best;
}

} // namespace

FoundPlace findPlace(const Features& moving, const Features& fixed, float spacing, const base::Progress& progress) {
    FoundPlace out;
    if (moving.feature.size() < 4 || fixed.feature.size() < 4)
        return out;
    progress.step(0, "Looking for its place");
    const std::vector<std::uint32_t> there = mostAlike(moving, fixed), back = mostAlike(fixed, moving);
    std::vector<Match> matches;
    for (std::uint32_t i = 0; i < there.size(); ++i)
        matches.push_back({i, there[i]});
    for (std::uint32_t j = 0; j < back.size(); ++j)
        if (there[back[j]] != j)
            matches.push_back({back[j], j});
    const bool oriented = moving.oriented && fixed.oriented;
    const Places places(fixed, nearby * static_cast<double>(spacing));
    progress.step(0.1, "Looking for its place");
    std::vector<FoundPlace> best = bestOfTasks(matches, moving, fixed, places, spacing, oriented);
    std::stable_sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
    for (std::size_t k = 0; k < keptBest; ++k) {
        const double share = shareOf(best[k].pose, moving, places, oriented, moving.position.size());
        if (share > out.share)
            out = {best[k].pose, share};
    }
    return out;
}

} // namespace process
