#include "core/process/registering/find_place.h"

#include "core/base/box.h"
#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <Eigen/Dense>

namespace process {

using base::Vec3d;

namespace {

constexpr std::size_t tries = 400000, tasks = 64, judged = 500;
constexpr double alikeLength = 0.9; ///< shorter over longer of the two
constexpr double leastSide = 4;     ///< of a pair, in spacings: small ones tell no direction
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
    /// The nearest point within the radius; none: the number of points.
    std::uint32_t nearest(const Vec3d& p) const {
        auto best = static_cast<std::uint32_t>(m_features.position.size());
        double bestSq = m_radius * m_radius;
        base::forCellsAround(cellAt(p), [&](const base::Cell& cell) {
            if (const std::vector<std::uint32_t>* there = m_cells.find(cell))
                for (const std::uint32_t i : *there)
                    if (const double d = distanceSq(p, m_features.position[i]); d < bestSq)
                        best = i, bestSq = d;
        });
        return best;
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

/// A pair of matches with the normals there, as four places: what a motion is made of.
struct Handle {
    Vec3d place[4];
};

/// Whether a pair of oriented points could be the other one moved: their distance, and the normals' angles with it and
/// with each other.
bool pairsAgree(const Vec3d (&a)[2], const Vec3d (&na)[2], const Vec3d (&b)[2], const Vec3d (&nb)[2], double least) {
    constexpr double angle = 0.2;
    const double p = distance(a[0], a[1]), q = distance(b[0], b[1]);
    if (!(std::min(p, q) > least && std::min(p, q) > alikeLength * std::max(p, q)))
        return false;
    const Vec3d d = (a[1] - a[0]) / p, e = (b[1] - b[0]) / q;
    const auto near = [](double x, double y) {
        return std::abs(std::acos(std::clamp(x, -1.0, 1.0)) - std::acos(std::clamp(y, -1.0, 1.0))) < angle;
    };
    return near(dot(na[0], d), dot(nb[0], e)) && near(dot(na[1], d), dot(nb[1], e)) &&
           near(dot(na[0], na[1]), dot(nb[0], nb[1]));
}

Handle handleOf(const Vec3d (&p)[2], const Vec3d (&n)[2]) {
    const double arm = distance(p[0], p[1]);
    return {{p[0], p[1], p[0] + n[0] * arm, p[1] + n[1] * arm}};
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

/// A start moved onto the planes of the nearest points, and the share of all points that are then close to one: within
/// a third of a spacing along its normal, which agrees.
FoundPlace refined(FoundPlace start, const Features& moving, const Features& fixed, const Places& places, float spacing,
                   bool oriented) {
    constexpr int rounds = 12;
    constexpr double agree = 0.8, close = 0.35;
    double squares = 0;
    std::size_t hits = 0;
    for (int round = 0; round <= rounds; ++round) {
        Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Identity() * 1e-6;
        Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
        hits = 0, squares = 0;
        const Vec3d centre = start.pose(moving.position.front());
        for (std::size_t i = 0; i < moving.position.size(); ++i) {
            const Vec3d p = start.pose(moving.position[i]);
            const std::uint32_t j = places.nearest(p);
            if (j >= fixed.position.size())
                continue;
            const Vec3d n = fixed.normal[j];
            const double along = dot(n, start.pose.turn(moving.normal[i])), off = dot(n, p - fixed.position[j]);
            if ((oriented ? along : std::abs(along)) < agree)
                continue;
            const bool isClose = std::abs(off) < close * static_cast<double>(spacing);
            hits += isClose, squares += isClose ? off * off : 0;
            const Vec3d arm = cross(p - centre, n);
            Eigen::Matrix<double, 6, 1> d;
            d << arm.x, arm.y, arm.z, n.x, n.y, n.z;
            normal += d * d.transpose();
            right -= off * d;
        }
        if (round == rounds)
            break;
        const Eigen::Matrix<double, 6, 1> step = normal.ldlt().solve(right);
        const Rigid turn = motionOf({step(0), step(1), step(2)}, {});
        start.pose =
            Rigid{turn.rotation, centre - turn.rotation * centre + Vec3d{step(3), step(4), step(5)}} * start.pose;
    }
    start.share = static_cast<double>(hits) / static_cast<double>(moving.position.size());
    return start;
}

/// The best of many places, best first, each of which differs from the others by more than three spacings somewhere.
class Shortlist {
  public:
    Shortlist(const Features& moving, float spacing, std::size_t most)
        : m_apartSq(9 * static_cast<double>(spacing) * static_cast<double>(spacing)), m_most(most) {
        base::Box3d box;
        for (const Vec3d& p : moving.position)
            box.extend(p);
        for (std::size_t k = 0; k < 4; ++k) // what moves none of these far moves none far
            m_corner[k] = {k & 1 ? box.hi.x : box.lo.x, k & 2 ? box.hi.y : box.lo.y,
                           (k ^ k >> 1) & 1 ? box.hi.z : box.lo.z};
    }
    /// What a place must beat to be kept.
    double least() const { return m_kept.size() < m_most ? 0 : m_kept.back().share; }
    void add(const FoundPlace& place) {
        const auto same = [&](const FoundPlace& other) {
            return std::all_of(std::begin(m_corner), std::end(m_corner),
                               [&](const Vec3d& p) { return distanceSq(place.pose(p), other.pose(p)) < m_apartSq; });
        };
        if (!(place.share > least()) || std::any_of(m_kept.begin(), m_kept.end(), [&](const FoundPlace& each) {
                return each.share >= place.share && same(each);
            }))
            return;
        std::erase_if(m_kept, same); // worse ones
        m_kept.insert(std::find_if(m_kept.begin(), m_kept.end(),
                                   [&](const FoundPlace& each) { return each.share < place.share; }),
                      place);
        if (m_kept.size() > m_most)
            m_kept.pop_back();
    }
    const std::vector<FoundPlace>& kept() const { return m_kept; }

  private:
    double m_apartSq;
    std::size_t m_most;
    Vec3d m_corner[4];
    std::vector<FoundPlace> m_kept;
};

/// Some of each task's tries: more than are wanted, as wrong places that cover more than the true one come first.
std::vector<FoundPlace> bestOfTasks(const std::vector<Match>& matches, const Features& moving, const Features& fixed,
                                    const Places& places, float spacing, bool oriented) {
    constexpr std::size_t ofEach = 48;
    std::vector<Shortlist> best(tasks, Shortlist(moving, spacing, ofEach));
    base::parallelFor(tasks, 1, [&](std::size_t task) {
        base::Random random(task);
        for (std::size_t t = 0; t < tries / tasks; ++t) {
            Vec3d a[2], b[2], na[2], nb[2];
            for (int k = 0; k < 2; ++k) {
                const Match& m = matches[random.below(matches.size())];
                a[k] = moving.position[m.moving], b[k] = fixed.position[m.fixed];
                na[k] = moving.normal[m.moving], nb[k] = fixed.normal[m.fixed];
                if (!oriented && random.uniform() < 0.5)
                    nb[k] = -nb[k];
            }
            Rigid pose;
            if (!pairsAgree(a, na, b, nb, leastSide * static_cast<double>(spacing)) ||
                !bestMotion(handleOf(a, na).place, handleOf(b, nb).place, 4, pose))
                continue;
            // few points rule most of them out
            if (shareOf(pose, moving, places, oriented, 40) < 0.8 * best[task].least())
                continue;
            best[task].add({pose, shareOf(pose, moving, places, oriented, judged)});
        }
    });
    std::vector<FoundPlace> out;
    for (const Shortlist& each : best)
        out.insert(out.end(), each.kept().begin(), each.kept().end());
    return out;
}

} // namespace

std::vector<FoundPlace> findPlaces(const Features& moving, const Features& fixed, float spacing, std::size_t most,
                                   const base::Progress& progress) {
    if (moving.feature.size() < 4 || fixed.feature.size() < 4)
        return {};
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
    constexpr std::size_t starts = 512;
    Shortlist apart(moving, spacing, starts); // tasks find the same places, which settle on the same one
    for (const FoundPlace& each : bestOfTasks(matches, moving, fixed, places, spacing, oriented))
        apart.add(each);
    std::vector<FoundPlace> best = apart.kept();
    base::parallelFor(best.size(), 1, [&](std::size_t k) {
        if (best[k].share > 0)
            best[k] = refined(best[k], moving, fixed, places, spacing, oriented);
    });
    Shortlist out(moving, spacing, most);
    for (const FoundPlace& each : best)
        out.add(each);
    return out.kept();
}

} // namespace process
