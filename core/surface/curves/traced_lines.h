// Segments of the curves traced so far, in cells: has somebody been along here? Internal to the room.
//
// A Point has position, unit (h) and tangent(). Lengths are in units of h.
#pragma once

#include "core/base/cells.h"

#include <algorithm>
#include <map>
#include <vector>

namespace surface {

class TracedLines {
  public:
    /// `cell`, in model units: at least as long as a segment, and a reach that is asked for more than half of one.
    explicit TracedLines(double cell) : m_cell(cell) {}

    template <class Point>
    void add(const std::vector<Point>& points, bool closed, std::size_t number) {
        const std::size_t count = points.size();
        const auto put = [&](const Point& a, const Point& b) {
            m_cells.at(cellOf((a.position + b.position) * 0.5))
                .push_back({a.position, b.position, a.tangent(), number});
        };
        for (std::size_t i = closed ? 0 : 1; i < count; ++i)
            put(points[i == 0 ? count - 1 : i - 1], points[i]);
        if (count == 1)
            put(points[0], points[0]);
    }

    /// The curve that comes within `reach` of p in its direction, or -1.
    template <class Point>
    std::ptrdiff_t lineAt(const Point& p, double reach) const {
        const base::Cell centre = cellOf(p.position);
        for (std::int64_t i = 0; i < 27; ++i) {
            const auto* segments = m_cells.find({centre.x + i % 3 - 1, centre.y + i / 3 % 3 - 1, centre.z + i / 9 - 1});
            if (!segments)
                continue;
            for (const Segment& s : *segments)
                if (distanceTo(s, p.position) < reach * p.unit && std::abs(dot(s.tangent, p.tangent())) > 0.5)
                    return static_cast<std::ptrdiff_t>(s.line);
        }
        return -1;
    }

    /// The curve that more than half of the points are close to, or -1.
    template <class Point>
    std::ptrdiff_t sameAs(const std::vector<Point>& points, double reach) const {
        std::map<std::ptrdiff_t, std::size_t> votes;
        for (const Point& p : points)
            if (const std::ptrdiff_t other = lineAt(p, reach); other >= 0 && 2 * ++votes[other] > points.size())
                return other;
        return -1;
    }

  private:
    struct Segment {
        base::Vec3d a, b, tangent;
        std::size_t line;
    };

    base::Cell cellOf(const base::Vec3d& p) const { return base::cellOf(p, {}, 1 / m_cell); }
    static double distanceTo(const Segment& s, const base::Vec3d& p) {
        const base::Vec3d way = s.b - s.a;
        const double square = lengthSq(way);
        const double part = square > 0 ? std::clamp(dot(p - s.a, way) / square, 0.0, 1.0) : 0;
        return distance(p, s.a + way * part);
    }

    double m_cell;
    base::CellMap<std::vector<Segment>> m_cells;
};

} // namespace surface
