#include "core/base/outline.h"

#include <algorithm>

namespace base {

Outline::Outline(std::span<const Point2> corners) {
    add(corners);
    sort();
}

Outline::Outline(std::span<const std::vector<Point2>> rings) {
    for (const std::vector<Point2>& ring : rings)
        add(ring);
    sort();
}

void Outline::add(std::span<const Point2> corners) {
    if (corners.size() < 3)
        return;
    if (m_edges.empty())
        m_lo = m_hi = corners[0];
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        m_edges.push_back({a, b});
        m_lo = {std::min(m_lo.x, a.x), std::min(m_lo.y, a.y)};
        m_hi = {std::max(m_hi.x, a.x), std::max(m_hi.y, a.y)};
    }
}

void Outline::sort() {
    if (m_edges.empty())
        return;
    const std::size_t rows = std::clamp<std::size_t>(2 * m_edges.size(), 1, 4096);
    m_rowsPerUnit = m_hi.y > m_lo.y ? static_cast<double>(rows) / (m_hi.y - m_lo.y) : 0;
    m_first.assign(rows + 1, 0);
    const auto forRows = [&](const Edge& edge, const auto& fn) {
        const auto [low, high] = std::minmax(edge.a.y, edge.b.y);
        for (std::size_t row = rowOf(low); row <= rowOf(high); ++row)
            fn(row);
    };
    for (const Edge& edge : m_edges)
        forRows(edge, [&](std::size_t row) { ++m_first[row + 1]; });
    for (std::size_t row = 0; row < rows; ++row)
        m_first[row + 1] += m_first[row];
    m_inRow.resize(m_first[rows]);
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t e = 0; e < m_edges.size(); ++e)
        forRows(m_edges[e], [&](std::size_t row) { m_inRow[next[row]++] = static_cast<std::uint32_t>(e); });
}

/// Monotonic in y, so that an edge is in every row between those of its ends.
std::size_t Outline::rowOf(double y) const {
    const double row = std::clamp((y - m_lo.y) * m_rowsPerUnit, 0.0, static_cast<double>(m_first.size() - 2));
    return static_cast<std::size_t>(row);
}

bool Outline::holds(const Point2& p) const {
    if (m_edges.empty() || !(p.x >= m_lo.x && p.x <= m_hi.x && p.y >= m_lo.y && p.y <= m_hi.y))
        return false;
    bool in = false;
    const std::size_t row = rowOf(p.y);
    for (std::uint32_t i = m_first[row]; i < m_first[row + 1]; ++i) {
        const auto& [a, b] = m_edges[m_inRow[i]];
        if ((a.y > p.y) == (b.y > p.y)) // half open, so that a corner counts once
            continue;
        in ^= p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y);
    }
    return in;
}

/// The part of an edge that lies in a rectangle, by slabs (Liang & Barsky 1984).
static bool passes(const Point2& a, const Point2& b, const Point2& lo, const Point2& hi) {
    double first = 0, last = 1;
    const auto slab = [&](double from, double step, double low, double high) {
        if (step == 0)
            return from >= low && from <= high;
        double t0 = (low - from) / step, t1 = (high - from) / step;
        if (t0 > t1)
            std::swap(t0, t1);
        first = std::max(first, t0), last = std::min(last, t1);
        return first <= last;
    };
    return slab(a.x, b.x - a.x, lo.x, hi.x) && slab(a.y, b.y - a.y, lo.y, hi.y);
}

bool Outline::meets(const Point2& lo, const Point2& hi) const {
    if (m_edges.empty() || lo.x > m_hi.x || hi.x < m_lo.x || lo.y > m_hi.y || hi.y < m_lo.y)
        return false;
    const std::size_t begin = m_first[rowOf(lo.y)], end = m_first[rowOf(hi.y) + 1];
    for (std::size_t i = begin; i < end; ++i)
        if (const auto& [a, b] = m_edges[m_inRow[i]]; passes(a, b, lo, hi))
            return true;
    return false;
}

} // namespace base
