#include "core/sculpt/brush_curve.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sculpt {

static void check(std::span<const CurvePoint> points, const char* name) {
    const auto within = [](float v) { return v >= 0 && v <= 1; };
    bool good = points.size() >= 2 && points.size() <= BrushCurve::maxPoints;
    for (std::size_t i = 0; good && i < points.size(); ++i)
        good = within(points[i].x) && within(points[i].y) &&
               (i == 0 || points[i].x - points[i - 1].x >= BrushCurve::minGap);
    if (!good)
        throw base::Error(std::string(name) + " is not a curve", "stroke",
                          "give 2 to 16 points [x,y] between 0 and 1, their x rising by at least 0.001");
}

/// Slope at an end from the secants d0 over h0 (at the end) and d1 over h1, limited so that the piece stays monotone.
static double endSlope(double h0, double h1, double d0, double d1) {
    const double m = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (m * d0 <= 0)
        return 0;
    return d0 * d1 <= 0 && std::abs(m) > 3 * std::abs(d0) ? 3 * d0 : m;
}

/// Slopes at all points: zero at turning points, else the weighted harmonic mean of the secants.
static std::vector<double> slopesOf(std::span<const CurvePoint> points) {
    const std::size_t n = points.size();
    std::vector<double> h(n - 1), d(n - 1), m(n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        h[i] = double(points[i + 1].x) - double(points[i].x);
        d[i] = (double(points[i + 1].y) - double(points[i].y)) / h[i];
    }
    if (n == 2)
        return {d[0], d[0]};
    for (std::size_t i = 1; i + 1 < n; ++i)
        m[i] = d[i - 1] * d[i] <= 0
                   ? 0
                   : 3 * (h[i - 1] + h[i]) / ((2 * h[i] + h[i - 1]) / d[i - 1] + (h[i] + 2 * h[i - 1]) / d[i]);
    m[0] = endSlope(h[0], h[1], d[0], d[1]);
    m[n - 1] = endSlope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
    return m;
}

BrushCurve::BrushCurve(std::span<const CurvePoint> points, const char* name) {
    check(points, name);
    const std::vector<double> m = slopesOf(points);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double h = double(points[i + 1].x) - double(points[i].x);
        const double d = (double(points[i + 1].y) - double(points[i].y)) / h;
        const double c = (3 * d - 2 * m[i] - m[i + 1]) / h, e = (m[i] + m[i + 1] - 2 * d) / (h * h);
        m_pieces.push_back({points[i].x, points[i].y, float(m[i]), float(c), float(e)});
    }
    m_first = points.front().x, m_last = points.back().x;
    m_pieces.push_back({m_last, points.back().y, 0, 0, 0});
}

const BrushCurve::Piece& BrushCurve::piece(float x) const {
    std::size_t i = 0;
    while (i + 1 < m_pieces.size() && x >= m_pieces[i + 1].from)
        ++i;
    return m_pieces[i];
}

float BrushCurve::value(float x) const {
    const Piece& p = piece(x);
    const float t = std::max(0.0f, x - p.from);
    return std::clamp(p.y + t * (p.b + t * (p.c + t * p.d)), 0.0f, 1.0f);
}

float BrushCurve::slope(float x) const {
    if (x < m_first || x > m_last)
        return 0;
    const Piece& p = piece(x);
    const float t = x - p.from;
    return p.b + t * (2 * p.c + t * 3 * p.d);
}

} // namespace sculpt
