// A closed outline in the plane of a picture, as a lasso draws it: what lies inside by the even-odd rule, in a time
// that does not grow with its corners.
//
// Edges are sorted into rows of equal height; a point looks at those of its own row, a rectangle at those of the rows
// it reaches over. An outline may cross itself: what it goes round twice is outside. Float64; a value.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace base {

struct Point2 {
    double x = 0, y = 0;
    auto operator<=>(const Point2&) const = default;
};

class Outline {
  public:
    Outline() = default;
    /// The last corner is joined to the first. REQUIRES: finite corners; fewer than three hold nothing.
    explicit Outline(std::span<const Point2> corners);
    /// Several of them at once: what lies in an even number is outside.
    explicit Outline(std::span<const std::vector<Point2>> rings);

    bool holds(const Point2& p) const;
    /// Does an edge come into the rectangle, or touch it?
    bool meets(const Point2& lo, const Point2& hi) const;

  private:
    struct Edge {
        Point2 a, b;
    };
    void add(std::span<const Point2> corners);
    void sort();
    std::size_t rowOf(double y) const;

    Point2 m_lo, m_hi;
    double m_rowsPerUnit = 0;
    std::vector<Edge> m_edges;
    std::vector<std::uint32_t> m_first, m_inRow; ///< of each row: where its edges begin in m_inRow
};

} // namespace base
