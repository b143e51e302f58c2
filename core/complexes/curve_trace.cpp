#include "core/complexes/curve_trace.h"

#include "core/base/segment.h"
#include "core/complexes/foot_on_cell.h"

#include <algorithm>

namespace complexes {

using base::Vec3d;

Vec3d TracedCurve::at(double way) const {
    const auto after = std::upper_bound(along.begin(), along.end(), way);
    if (after == along.begin())
        return points.front();
    if (after == along.end())
        return points.back();
    const auto i = static_cast<std::size_t>(after - along.begin());
    return points[i - 1] + (points[i] - points[i - 1]) * ((way - along[i - 1]) / (along[i] - along[i - 1]));
}

double TracedCurve::wayOf(const Vec3d& x) const {
    double best = 0, nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double share = nearestShare(points[i - 1], points[i], x);
        const double distance = base::distanceSq(x, points[i - 1] + (points[i] - points[i - 1]) * share);
        if (distance < nearest) {
            nearest = distance;
            best = along[i - 1] + share * (along[i] - along[i - 1]);
        }
    }
    return best;
}

namespace {

/// Steps from where a curve begins until it ends, or is back.
class Tracer {
  public:
    Tracer(const Complex& complex, std::uint32_t curve) : m_complex(complex), m_curve(curve) {
        const Cell& cell = complex[curve];
        const std::size_t count = cell.own.tree().size();
        double h = 0;
        cell.own.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                h += static_cast<double>(surface::unitOf(complex.weight(), block.support(slot)));
        });
        m_out.spacing = surface::spacingOfUnit * h / static_cast<double>(count);
        m_most = 64 * count + 1024;
        m_out.closed = cell.boundary.size() < 2;
        m_begin = cell.boundary.empty() ? base::cast<double>(cell.own.tree().block(0)->position(0))
                                        : complex.place(cell.boundary.front());
        m_end = cell.boundary.size() == 2 ? complex.place(cell.boundary.back()) : m_begin;
    }

    TracedCurve run() {
        put(m_begin);
        const CellFrame first = frameOf(m_complex, m_curve, m_begin);
        Vec3d direction = dot(first.axis, first.ownCentre - m_begin) < 0 ? -first.axis : first.axis;
        FootOptions free;
        free.restricted = false;
        for (std::size_t i = 0; i < m_most; ++i) {
            const Vec3d from = m_out.points.back();
            const double step = 0.25 * m_out.spacing;
            if (m_out.length() > 2 * m_out.spacing && base::distance(from, m_end) < 1.5 * step)
                break;
            const CellFoot foot = footOn(m_complex, m_curve, from + direction * step, free);
            const Vec3d moved = foot.position - from;
            if (!foot.ok() || !(dot(moved, direction) > 0.1 * step))
                break;
            if (!m_out.closed && m_out.length() < 2 * m_out.spacing && past(foot.position))
                break; // a curve shorter than that
            put(foot.position);
            direction = normalized(moved);
        }
        put(m_end);
        return std::move(m_out);
    }

  private:
    bool past(const Vec3d& x) const { return dot(x - m_end, m_end - m_begin) >= 0; }
    void put(const Vec3d& x) {
        m_out.along.push_back(m_out.points.empty() ? 0 : m_out.along.back() + base::distance(x, m_out.points.back()));
        m_out.points.push_back(x);
    }

    const Complex& m_complex;
    std::uint32_t m_curve;
    TracedCurve m_out;
    Vec3d m_begin, m_end;
    std::size_t m_most = 0;
};

} // namespace

TracedCurve trace(const Complex& complex, std::uint32_t curve) {
    return Tracer(complex, curve).run();
}

} // namespace complexes
