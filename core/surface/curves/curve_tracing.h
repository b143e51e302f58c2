// Following a curve on the surface by predictor and corrector, whatever it is that singles the curve out:
// boundaries (boundary.h) and plane sections (section.h). Internal to the room.
//
// A Problem tells what a point of the curve is:
//
//     struct Problem {
//         using Point = ...;                            // position, normal, unit (h), and tangent(), unit length
//         const Surface& surface() const;
//         std::optional<Point> find(start, hint) const; // Newton's iteration from near the curve
//         bool holds(const Point&) const;               // false: the curve has ended before that point
//     };
//
// A step goes along the tangent and is corrected by `find`; it is halved until it leads on, and chosen by the turn just
// seen. Where the curve stops holding, its last point is found by bisection. All of it is float64.
#pragma once

#include "core/surface/curves/boundary.h"
#include "core/surface/curves/kinks.h"

#include <algorithm>
#include <optional>

namespace surface {

inline double angleBetween(const base::Vec3d& a, const base::Vec3d& b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

/// One direction of `traceCurve`.
template <class Problem>
class CurveTracing {
  public:
    using Point = typename Problem::Point;

    CurveTracing(const Problem& problem, const Point& seed, double sense, const TraceOptions& options)
        : m_problem(problem), m_options(options), m_sense(sense), m_at(seed),
          m_step(0.25 * options.longestStep * seed.unit) {}

    /// Appends points to the seed until the curve closes (true) or ends. Where f has a step, the way from the seed may
    /// lead into a loop that does not come back to it: then the loop alone is kept (found as in [Brent80]). The seed is
    /// looked for all the same: a kink that is stepped over once may end the next round before it comes to a mark.
    bool run(std::vector<Point>& out) {
        std::size_t mark = 0, nextMark = 64;
        while (out.size() < m_options.mostPoints && !m_ended) {
            Point next;
            if (!go(next))
                return false;
            if (out.size() > 2 && passes(out.front(), next))
                return true;
            if (out.size() > mark + 2 && passes(out[mark], next)) {
                out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(mark));
                return true;
            }
            out.push_back(next);
            choose(next);
            m_at = next;
            if (out.size() == nextMark) {
                mark = nextMark - 1;
                nextMark *= 2;
            }
        }
        return false;
    }

  private:
    enum class Found { Nothing, Next, End };

    base::Vec3d along(const Point& p) const { return p.tangent() * m_sense; }

    /// The sign of frames that have none. Others are asked as everybody asks them.
    OrientationHint hint() const {
        return m_problem.surface().tree().layout()->oriented ? OrientationHint{}
                                                             : OrientationHint{base::cast<float>(m_at.normal)};
    }

    /// The next point, half as far as often as it takes to find it where the curve was heading; else farther, over the
    /// steps that f has where near sheets meet.
    bool go(Point& next) {
        const double first = m_step;
        for (; m_step > m_options.shortestStep * m_at.unit; m_step *= 0.5)
            if (const Found found = leadsOn(m_step, next); found != Found::Nothing)
                return found == Found::Next || end(next);
        for (m_step = 2 * first; m_step <= m_options.longestStep * m_at.unit; m_step *= 2)
            if (leadsOn(m_step, next) == Found::Next)
                return true;
        return false;
    }

    Found leadsOn(double step, Point& next) const {
        const auto found = m_problem.find(m_at.position + along(m_at) * step, hint());
        if (!found)
            return Found::Nothing;
        const base::Vec3d way = found->position - m_at.position;
        const double gone = length(way);
        if (!(gone > 0.5 * step && gone < 1.5 * step && angleBetween(along(m_at), along(*found)) < 4 * m_options.turn &&
              dot(way, along(m_at)) > 0.9 * gone && dot(found->normal, m_at.normal) > 0.5))
            return Found::Nothing;
        if (!m_problem.holds(*found))
            return Found::End;
        next = *found;
        return Found::Next;
    }

    /// The last point that holds, between the current one and a step on.
    bool end(Point& next) {
        constexpr int halvings = 40;
        m_ended = true;
        double low = 0, high = m_step;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (low + high);
            (leadsOn(middle, next) == Found::Next ? low : high) = middle;
        }
        return low > 0;
    }

    /// By the curvature just seen, at most twice as far as before.
    void choose(const Point& next) {
        const double gone = distance(next.position, m_at.position), turned = angleBetween(along(m_at), along(next));
        const double wanted = m_options.turn * gone / std::max(turned, 1e-6);
        m_step = std::clamp(wanted, 4 * m_options.shortestStep * next.unit,
                            std::min(2 * m_step, m_options.longestStep * next.unit));
    }

    /// Whether `mark` lies between the current point and the next.
    bool passes(const Point& mark, const Point& next) const {
        const base::Vec3d way = next.position - m_at.position, home = mark.position - m_at.position;
        const double part = dot(home, way) / lengthSq(way);
        return part > 0 && part <= 1 && length(home - way * part) < 0.25 * length(way) &&
               dot(along(next), along(mark)) > 0.5 && dot(next.normal, mark.normal) > 0.5;
    }

    const Problem& m_problem;
    const TraceOptions& m_options;
    double m_sense; ///< 1 along the tangents, -1 against them
    Point m_at;
    double m_step;
    bool m_ended = false; ///< the last point appended is the curve's
};

template <class Point>
struct TracedCurve {
    std::vector<Point> points;
    bool closed = false;
};

/// From one of its points, both ways where it does not close.
template <class Problem>
TracedCurve<typename Problem::Point> traceCurve(const Problem& problem, const typename Problem::Point& seed,
                                                const TraceOptions& options) {
    TracedCurve<typename Problem::Point> out;
    out.points.push_back(seed);
    out.closed = CurveTracing(problem, seed, 1, options).run(out.points);
    if (out.closed)
        return out;
    std::vector<typename Problem::Point> before{seed};
    const bool loop = CurveTracing(problem, seed, -1, options).run(before);
    std::reverse(before.begin(), before.end());
    if (loop) // as it is the other way round
        return {std::move(before), true};
    before.insert(before.end(), out.points.begin() + 1, out.points.end());
    out.points = std::move(before);
    constexpr double near = 0.02; // of h; steps end at a thousandth
    out.closed = closeAtAKink(out.points, near);
    return out;
}

/// Of the arcs between the points: each bends by the angle between its ends' tangents.
template <class Point>
double arcLength(const std::vector<Point>& points, bool closed) {
    double sum = 0;
    for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
        const Point &a = points[i == 0 ? points.size() - 1 : i - 1], &b = points[i];
        const double half = 0.5 * angleBetween(a.tangent(), b.tangent());
        sum += distance(a.position, b.position) * (half > 1e-6 ? half / std::sin(half) : 1);
    }
    return sum;
}

} // namespace surface
