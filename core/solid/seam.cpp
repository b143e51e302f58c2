#include "core/solid/seam.h"

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

  private:
    const std::vector<SeamSeed>& m_seeds;
    std::vector<std::uint8_t> m_passed;
    process::PointGrid m_grid;
    double m_widest = 0;
};

class Tracer {
  public:
    Tracer(const TwoSides& sides, Seeds& seeds) : m_sides(sides), m_seeds(seeds) {}

    SeamCurve from(const SeamPoint& start, double spacing) {
        SeamCurve forth = way(start, spacing, 1);
        if (forth.closed)
            return forth;
        SeamCurve back = way(start, spacing, -1), out;
        const std::size_t before = back.points.size() - 1; // the start is in both
        out.points.assign(back.points.rbegin(), back.points.rend() - 1);
        out.points.insert(out.points.end(), forth.points.begin(), forth.points.end());
        for (auto it = back.corners.rbegin(); it != back.corners.rend(); ++it)
            out.corners.push_back(before - *it - 1);
        for (const std::size_t corner : forth.corners)
            out.corners.push_back(before + corner);
        return out;
    }

  private:
    /// Shorter steps than this part of the longest one, over which a gradient still turns, pass a corner.
    static constexpr double least = 1.0 / 64;
    static constexpr std::size_t most = 10'000'000;

    static bool turns(const SeamPoint& a, const SeamPoint& b) {
        constexpr double cosine = 0.94; // 20 degrees
        return dot(a.risesA, b.risesA) < cosine || dot(a.risesB, b.risesB) < cosine;
    }
    SeamCurve way(const SeamPoint& start, double spacing, double sign) {
        SeamCurve out;
        out.points.push_back(start);
        for (double step = 0.5 * spacing; out.points.size() < most;) {
            base::CancelScope::check();
            const SeamPoint at = out.points.back();
            spacing = m_seeds.pass(at.position, spacing);
            const double longest = 0.5 * spacing;
            step = std::min(2 * step, longest);
            std::optional<SeamPoint> next;
            for (; step >= least * longest; step *= 0.5) {
                next = seamPoint(m_sides, at.position + at.tangent() * (sign * step), seamTolerance * spacing);
                const double gone = next ? dot(next->position - at.position, at.tangent()) * sign : 0;
                const bool good = next && gone > 0.2 * step && distance(next->position, at.position) < 2 * step;
                if (good && (!turns(at, *next) || step < 2 * least * longest))
                    break;
                next.reset();
            }
            if (!next)
                return out;
            if (turns(at, *next))
                out.corners.push_back(out.points.size() - 1);
            if (out.points.size() > 2 && returns(at, *next, start, sign)) {
                out.closed = true;
                return out;
            }
            out.points.push_back(*next);
        }
        return out;
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
};

} // namespace

std::vector<SeamCurve> traceSeams(const TwoSides& sides, const std::vector<SeamSeed>& list) {
    Seeds seeds(list);
    Tracer tracer(sides, seeds);
    std::vector<SeamCurve> out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (seeds.passed(i))
            continue;
        const std::optional<SeamPoint> start = seamPoint(sides, list[i].position, seamTolerance * list[i].spacing);
        if (!start || distance(start->position, list[i].position) > list[i].spacing)
            continue;
        SeamCurve curve = tracer.from(*start, list[i].spacing);
        for (const SeamPoint& p : curve.points) // steps passed all but the last
            seeds.pass(p.position, list[i].spacing);
        if (curve.points.size() > 1)
            out.push_back(std::move(curve));
    }
    return out;
}

} // namespace solid
