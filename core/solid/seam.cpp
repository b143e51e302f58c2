#include "core/solid/seam.h"

#include "core/solid/seam_corner.h"

#include "core/base/cancel_scope.h"
#include "core/process/resampling/point_grid.h"

#include <algorithm>
#include <limits>

namespace solid {

using base::Vec3d;

std::optional<SeamPoint> seamPoint(const TwoSides& sides, const Vec3d& x, double tolerance) {
    constexpr int steps = 12;
    constexpr double leastSine = 0.1; // squared sine 0.01, as in cells/README 5
    Vec3d y = x;
    for (int step = 0; step < steps; ++step) {
        const SideValue f = sides.a(y), g = sides.b(y);
        if (!f.near || !g.near)
            return {};
        const double c = dot(f.gradient, g.gradient), det = 1 - c * c;
        if (det < leastSine * leastSine)
            return {};
        const double u = f.value + dot(f.gradient, x - y), v = g.value + dot(g.gradient, x - y);
        const Vec3d next = x - f.gradient * ((u - c * v) / det) - g.gradient * ((v - c * u) / det);
        const double moved = distance(next, y);
        y = next;
        if (moved < tolerance)
            return SeamPoint{y, f.gradient, g.gradient};
    }
    return {};
}

double SeamCurve::length() const {
    double out = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        out += distance(points[i].position, points[i + 1].position);
    return closed && points.size() > 1 ? out + distance(points.back().position, points.front().position) : out;
}

namespace {

/// Seeds by place: how large steps are, and which of them a curve has passed.
class Seeds {
  public:
    explicit Seeds(const std::vector<SeamSeed>& seeds) : m_seeds(seeds), m_passed(seeds.size(), 0), m_grid({}, 1) {
        base::Box3d box;
        std::vector<process::PointGrid::Entry> entries;
        for (std::uint32_t i = 0; i < seeds.size(); ++i) {
            box.extend(seeds[i].position);
            m_widest = std::max(m_widest, seeds[i].spacing);
            m_least = std::min(m_least, seeds[i].spacing);
            entries.push_back({base::cast<float>(seeds[i].position), i});
        }
        if (seeds.empty())
            return;
        const double cell = std::max({m_widest, 1e-5 * box.diagonal(), 1e-30});
        m_grid = process::PointGrid(base::cast<float>(box.lo), static_cast<float>(cell));
        m_grid.build(entries);
    }
    bool passed(std::size_t i) const { return m_passed[i] != 0; }
    /// The spacing about a place, from the nearest seed; `last` where there is none near.
    double pass(const Vec3d& x, double last) {
        double nearest = std::numeric_limits<double>::infinity(), out = last;
        m_grid.forNear(base::cast<float>(x), static_cast<float>(m_widest), [&](const auto& entry) {
            const SeamSeed& seed = m_seeds[entry.index];
            const double apart = distance(seed.position, x);
            if (apart <= seed.spacing)
                m_passed[entry.index] = 1;
            if (apart < nearest) {
                nearest = apart;
                out = seed.spacing;
            }
        });
        return out;
    }

    /// What lies along a curve: seeds of the finer side stand closer than steps may be long.
    void pass(const SeamCurve& curve, double spacing) {
        constexpr double mostParts = 64;
        const std::size_t n = curve.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3d from = curve.points[i].position, to = curve.points[i + 1 < n      ? i + 1
                                                                           : curve.closed ? 0
                                                                                          : i]
                                                                  .position;
            const double parts = std::clamp(std::ceil(2 * distance(from, to) / m_least), 1.0, mostParts);
            for (double k = 0; k < parts; ++k)
                pass(from + (to - from) * (k / parts), spacing);
        }
    }

  private:
    const std::vector<SeamSeed>& m_seeds;
    std::vector<std::uint8_t> m_passed;
    process::PointGrid m_grid;
    double m_widest = 0, m_least = std::numeric_limits<double>::infinity();
};

class Tracer {
  public:
    /// `most`: points of a curve, should it not end.
    Tracer(const TwoSides& sides, Seeds& seeds, std::size_t most) : m_sides(sides), m_seeds(seeds), m_most(most) {}

    SeamCurve from(const SeamPoint& start, double spacing) {
        SeamCurve forth = way(start, spacing, 1);
        if (forth.closed)
            return forth;
        SeamCurve back = way(start, spacing, -1), out;
        if (back.closed) { // what the other way saw is on it
            std::reverse(back.points.begin(), back.points.end());
            std::reverse(back.corners.begin(), back.corners.end());
            for (std::size_t& corner : back.corners)
                corner = back.points.size() - 1 - corner;
            return back;
        }
        const std::size_t before = back.points.size() - 1; // the start is in both
        out.points.assign(back.points.rbegin(), back.points.rend() - 1);
        out.points.insert(out.points.end(), forth.points.begin(), forth.points.end());
        for (auto it = back.corners.rbegin(); it != back.corners.rend(); ++it)
            out.corners.push_back(before - *it);
        for (const std::size_t corner : forth.corners)
            out.corners.push_back(before + corner);
        return out;
    }

  private:
    /// Where steps shorter than this part of the longest one do not go on there is a corner.
    static constexpr double least = 1.0 / 64;

    SeamCurve way(const SeamPoint& start, double spacing, double sign) {
        SeamCurve out;
        out.points.push_back(start);
        double forward = sign; // of the tangent: an edge may turn it
        for (double step = 0.5 * spacing; out.points.size() < m_most;) {
            base::CancelScope::check();
            const SeamPoint at = out.points.back();
            spacing = m_seeds.pass(at.position, spacing);
            const double longest = 0.5 * spacing;
            step = std::min(2 * step, longest);
            std::optional<SeamPoint> next;
            for (; step >= least * longest; step *= 0.5) {
                next = seamPoint(m_sides, at.position + at.tangent() * (forward * step), seamTolerance * spacing);
                const double gone = next ? dot(next->position - at.position, at.tangent()) * forward : 0;
                if (next && gone > 0.2 * step && distance(next->position, at.position) < 2 * step &&
                    !turnsBetween(at, *next))
                    break;
                next.reset();
            }
            if (next) {
                if (closes(out, *next, start, sign))
                    return out;
                out.points.push_back(*next);
                forward = dot(next->tangent(), next->position - at.position) < 0 ? -1 : 1;
                continue;
            }
            const std::optional<SeamTurn> turn = aroundCorner(m_sides, at, forward, spacing);
            if (!turn || comesBack(out, *turn, at.tangent() * forward, spacing)) {
                closesAtCorner(out, at.position, spacing);
                return out;
            }
            if (turn->corner) {
                if (closes(out, *turn->corner, start, sign) || closesAtCorner(out, turn->corner->position, spacing))
                    return out;
                out.corners.push_back(out.points.size());
                out.points.push_back(*turn->corner);
            }
            if (closes(out, turn->next, start, sign))
                return out;
            out.points.push_back(turn->next);
            forward = dot(turn->next.tangent(), turn->next.position - out.points[out.points.size() - 2].position) < 0
                          ? -1
                          : 1;
            step = least * longest;
        }
        return out;
    }
    /// Has the curve passed this corner? What came before it does not count then: the start was beside the seam.
    static bool closesAtCorner(SeamCurve& curve, const Vec3d& place, double spacing) {
        constexpr double near = 0.1;
        constexpr std::size_t least = 4; // points between
        for (std::size_t k = 0; k < curve.corners.size(); ++k) {
            const std::size_t i = curve.corners[k];
            if (i + least > curve.points.size() || distance(curve.points[i].position, place) > near * spacing)
                continue;
            while (curve.corners.size() > k + 1 && curve.corners.back() + least > curve.points.size() &&
                   distance(curve.points[curve.corners.back()].position, place) <= near * spacing) {
                curve.points.resize(curve.corners.back());
                curve.corners.pop_back();
            }
            curve.points.erase(curve.points.begin(), curve.points.begin() + static_cast<std::ptrdiff_t>(i));
            curve.corners.erase(curve.corners.begin(), curve.corners.begin() + static_cast<std::ptrdiff_t>(k));
            for (std::size_t& corner : curve.corners)
                corner -= i;
            curve.closed = true;
            return true;
        }
        return false;
    }
    /// Back the way it came, or on the spot?
    static bool comesBack(const SeamCurve& curve, const SeamTurn& turn, const Vec3d& forwards, double spacing) {
        constexpr double leastTip = -0.9975; // 4 degrees
        const Vec3d& from = turn.corner ? turn.corner->position : curve.points.back().position;
        if (dot(forwards, normalized(turn.next.position - from)) < leastTip)
            return true;
        return turn.corner && !curve.corners.empty() &&
               distance(curve.points[curve.corners.back()].position, from) < 0.01 * spacing;
    }
    static bool closes(SeamCurve& curve, const SeamPoint& next, const SeamPoint& start, double sign) {
        curve.closed = curve.points.size() > 2 && returns(curve.points.back(), next, start, sign);
        return curve.closed;
    }
    /// Does the step come by the start?
    static bool returns(const SeamPoint& at, const SeamPoint& next, const SeamPoint& start, double sign) {
        const Vec3d step = next.position - at.position, to = start.position - at.position;
        const double along = dot(to, step) / dot(step, step);
        return along > 1e-6 && along <= 1 + 1e-6 && length(to - step * along) < 0.2 * length(step) &&
               dot(start.tangent(), step) * sign > 0;
    }

    const TwoSides& m_sides;
    Seeds& m_seeds;
    std::size_t m_most;
};

} // namespace

std::vector<SeamCurve> traceSeams(const TwoSides& sides, const std::vector<SeamSeed>& list) {
    Seeds seeds(list);
    // some seeds to a spacing, two steps to a spacing and some at corners
    Tracer tracer(sides, seeds, 1000 + 64 * list.size());
    std::vector<SeamCurve> out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (seeds.passed(i))
            continue;
        const std::optional<SeamPoint> start = seamPoint(sides, list[i].position, seamTolerance * list[i].spacing);
        if (!start || distance(start->position, list[i].position) > list[i].spacing)
            continue;
        SeamCurve curve = tracer.from(*start, list[i].spacing);
        seeds.pass(curve, list[i].spacing);
        if (curve.points.size() > 1)
            out.push_back(std::move(curve));
    }
    return out;
}

} // namespace solid
