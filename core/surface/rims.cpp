#include "core/surface/rims.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

namespace surface {

using base::Vec3d, base::Vec3f;

namespace {

/// In units of h: o from which a surfel may have a rim near it. The last row of a regular sheet has 0.13 (alg. 6).
constexpr double seedOffCentre = 0.1;
constexpr double seedReach = 1; ///< in units of h: a rim farther off than that is another surfel's
constexpr double onRim = 0.02;  ///< in units of h: how far a rim point may be from the polyline of its rim
constexpr double sameRim = 0.1; ///< in units of h: two rims that are so close for half their way are one
constexpr std::size_t slab = 65536;

/// Rim points by their surfels, in tree order.
std::vector<RimPoint> findSeeds(const Surface& surface, const base::Progress& progress) {
    std::vector<Vec3f> x;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            x.push_back(block.position(slot));
    });
    const double limit = static_cast<double>(surface.definition().boundaryLimit);
    const double least = std::min(seedOffCentre, 0.5 * limit);
    std::vector<RimPoint> out;
    std::vector<Evaluationf> at;
    std::vector<RimSearch> found;
    for (std::size_t from = 0; from < x.size(); from += slab) {
        progress.step(0.7 * static_cast<double>(from) / static_cast<double>(x.size()), "Looking for rims");
        const std::size_t n = std::min(slab, x.size() - from);
        at.assign(n, {});
        found.assign(n, {});
        surface.evaluate(std::span(x).subspan(from, n), Need::Value, at);
        base::parallelFor(n, 64, [&](std::size_t i) {
            if (!(at[i].status == Status::BeyondBoundary || at[i].ok()) ||
                !(static_cast<double>(at[i].offCentre) > least * static_cast<double>(at[i].unit)))
                return;
            const Vec3d start = base::cast<double>(x[from + i]);
            found[i] = findRimPoint(surface, start);
            if (distance(found[i].point.position, start) > seedReach * found[i].point.unit)
                found[i].status = Status::NotConverged;
        });
        for (const RimSearch& each : found)
            if (each.ok())
                out.push_back(each.point);
    }
    return out;
}

/// Segments of the rims traced so far, in cells.
class Traced {
  public:
    explicit Traced(double cell) : m_cell(cell) {}

    void add(const Rim& rim, std::size_t number) {
        const std::size_t count = rim.points.size();
        for (std::size_t i = rim.closed ? 0 : 1; i < count; ++i) {
            const RimPoint &a = rim.points[i == 0 ? count - 1 : i - 1], &b = rim.points[i];
            m_cells[keyOf((a.position + b.position) * 0.5)].push_back({a.position, b.position, a.tangent(), number});
        }
        if (count == 1)
            m_cells[keyOf(rim.points[0].position)].push_back(
                {rim.points[0].position, rim.points[0].position, rim.points[0].tangent(), number});
    }

    /// The rim that comes within `reach` of p, or -1.
    std::ptrdiff_t rimAt(const RimPoint& p, double reach) const {
        const Key centre = keyOf(p.position);
        for (std::int64_t i = 0; i < 27; ++i) {
            const auto cell = m_cells.find({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
            if (cell == m_cells.end())
                continue;
            for (const Segment& s : cell->second)
                if (distanceTo(s, p.position) < reach * p.unit && std::abs(dot(s.tangent, p.tangent())) > 0.5)
                    return static_cast<std::ptrdiff_t>(s.rim);
        }
        return -1;
    }

    /// The rim that half the points of `rim` are close to, or -1.
    std::ptrdiff_t sameAs(const Rim& rim) const {
        std::map<std::ptrdiff_t, std::size_t> votes;
        for (const RimPoint& p : rim.points)
            if (const std::ptrdiff_t other = rimAt(p, sameRim); other >= 0 && 2 * ++votes[other] > rim.points.size())
                return other;
        return -1;
    }

  private:
    using Key = std::array<std::int64_t, 3>;
    struct KeyHash {
        std::size_t operator()(const Key& k) const {
            return static_cast<std::size_t>(k[0] * 73856093 ^ k[1] * 19349663 ^ k[2] * 83492791);
        }
    };
    struct Segment {
        Vec3d a, b, tangent;
        std::size_t rim;
    };

    Key keyOf(const Vec3d& p) const {
        return {static_cast<std::int64_t>(std::floor(p.x / m_cell)),
                static_cast<std::int64_t>(std::floor(p.y / m_cell)),
                static_cast<std::int64_t>(std::floor(p.z / m_cell))};
    }
    static double distanceTo(const Segment& s, const Vec3d& p) {
        const Vec3d way = s.b - s.a;
        const double square = lengthSq(way);
        const double part = square > 0 ? std::clamp(dot(p - s.a, way) / square, 0.0, 1.0) : 0;
        return distance(p, s.a + way * part);
    }

    double m_cell; ///< at least as long as a segment, and `sameRim` more than half of one
    std::unordered_map<Key, std::vector<Segment>, KeyHash> m_cells;
};

} // namespace

std::vector<Rim> findRims(const Surface& surface, const base::Progress& progress, const TraceOptions& options) {
    std::vector<Rim> out;
    if (!std::isfinite(surface.definition().boundaryLimit) || surface.tree().empty())
        return out;
    const std::vector<RimPoint> seeds = findSeeds(surface, progress);
    double longest = 0;
    for (const RimPoint& seed : seeds)
        longest = std::max(longest, seed.unit);
    Traced traced((1.5 * options.longestStep + sameRim) * std::max(longest, 1e-300));
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (i % 64 == 0)
            progress.step(0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(seeds.size()), "Following rims");
        std::ptrdiff_t place = traced.rimAt(seeds[i], onRim);
        if (place < 0) {
            Rim rim = traceRim(surface, seeds[i], options);
            place = traced.sameAs(rim);
            if (place < 0) {
                place = static_cast<std::ptrdiff_t>(out.size());
                traced.add(rim, out.size());
                out.push_back(std::move(rim));
            }
        }
        ++out[static_cast<std::size_t>(place)].surfels;
    }
    std::erase_if(out, [](const Rim& rim) { return rim.points.size() < 2; }); // nowhere to go from there
    std::stable_sort(out.begin(), out.end(), [](const Rim& a, const Rim& b) { return a.length() > b.length(); });
    return out;
}

} // namespace surface
