// Segments of the curves traced so far, in cells: has somebody been along here? Internal to the room.
//
// A Point has position, unit (h) and tangent(). Cells come in levels, with sides of powers of two: a segment lies in
// one of its own length, and who asks looks around in those of its own reach. So places are as cheap where all is fine,
// however wide the supports of others; the answer does not depend on the cells. One thread at a time.
#pragma once

#include "core/base/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace surface {

class TracedLines {
  public:
    template <class Point>
    void add(const std::vector<Point>& points, bool closed, std::size_t number) {
        const std::size_t count = points.size();
        const auto put = [&](const Point& a, const Point& b) {
            const double least = shortest * std::max(a.unit, b.unit);
            add({a.position, b.position, a.tangent(), number},
                levelOf(std::max(distance(a.position, b.position), least)));
        };
        for (std::size_t i = closed ? 0 : 1; i < count; ++i)
            put(points[i == 0 ? count - 1 : i - 1], points[i]);
        if (count == 1)
            put(points[0], points[0]);
    }

    /// The first of the curves that come within `reach`, in units of h, of p in its direction, or -1.
    template <class Point>
    std::ptrdiff_t lineAt(const Point& p, double reach) {
        const double radius = reach * p.unit;
        const int level = levelOf(std::max(2 * radius, shortest * p.unit));
        std::ptrdiff_t out = -1;
        const auto look = [&](const Cells& cells, int at) {
            base::forCellsAround(cellOf(p.position, at), [&](const base::Cell& cell) {
                if (const auto* numbers = cells.find(cell))
                    for (const std::size_t i : *numbers)
                        meet(m_segments[i], p.position, p.tangent(), radius, out);
            });
        };
        look(upTo(level), level);
        for (auto above = m_own.upper_bound(level); above != m_own.end(); ++above)
            look(above->second, above->first);
        return out;
    }

    /// The curve that more than half of the points are close to, or -1.
    template <class Point>
    std::ptrdiff_t sameAs(const std::vector<Point>& points, double reach) {
        std::map<std::ptrdiff_t, std::size_t> votes;
        for (const Point& p : points)
            if (const std::ptrdiff_t other = lineAt(p, reach); other >= 0 && 2 * ++votes[other] > points.size())
                return other;
        return -1;
    }

    /// Segments that were compared with places so far: what looking costs.
    std::size_t compared() const { return m_compared; }

  private:
    static constexpr double shortest = 0.25; ///< in units of h: shorter ones lie in cells of this one
    using Cells = base::CellMap<std::vector<std::size_t>>;
    struct Segment {
        base::Vec3d a, b, tangent;
        std::size_t line;
        int level = 0;

        base::Vec3d middle() const { return (a + b) * 0.5; }
    };

    /// Of the cells with sides from `size` to twice as long: a segment's middle is in the same or the next cell as all
    /// that comes within half a side of it.
    static int levelOf(double size) { return std::ilogb(std::clamp(size, 1e-300, 1e300)) + 1; }
    static base::Cell cellOf(const base::Vec3d& p, int level) { return base::cellOf(p, {}, std::ldexp(1.0, -level)); }

    void add(Segment segment, int level) {
        segment.level = level;
        const std::size_t number = m_segments.size();
        m_own[level].at(cellOf(segment.middle(), level)).push_back(number);
        for (auto at = m_upTo.lower_bound(level); at != m_upTo.end(); ++at)
            at->second.at(cellOf(segment.middle(), at->first)).push_back(number);
        m_segments.push_back(segment);
    }
    /// All segments of a level and below it, in cells of that level.
    const Cells& upTo(int level) {
        const auto [at, fresh] = m_upTo.try_emplace(level);
        if (fresh)
            for (std::size_t i = 0; i < m_segments.size(); ++i)
                if (m_segments[i].level <= level)
                    at->second.at(cellOf(m_segments[i].middle(), level)).push_back(i);
        return at->second;
    }

    void meet(const Segment& s, const base::Vec3d& p, const base::Vec3d& tangent, double radius, std::ptrdiff_t& out) {
        ++m_compared;
        const auto line = static_cast<std::ptrdiff_t>(s.line);
        if ((out < 0 || line < out) && distanceTo(s, p) < radius && std::abs(dot(s.tangent, tangent)) > 0.5)
            out = line;
    }
    static double distanceTo(const Segment& s, const base::Vec3d& p) {
        const base::Vec3d way = s.b - s.a;
        const double square = lengthSq(way);
        const double part = square > 0 ? std::clamp(dot(p - s.a, way) / square, 0.0, 1.0) : 0;
        return distance(p, s.a + way * part);
    }

    std::vector<Segment> m_segments;
    std::map<int, Cells> m_own;  ///< by level, the segments of that level
    std::map<int, Cells> m_upTo; ///< of the levels that were asked for
    std::size_t m_compared = 0;
};

} // namespace surface
