#include "core/surface/curves/curve.h"

#include <algorithm>

namespace surface {

using base::Vec3d;

namespace {

/// The iteration of surface/README 3.2 in codimension two, relaxed as on surfaces (project.cpp).
class CurveProjecting {
  public:
    CurveProjecting(const Surface& curve, const Vec3d& x0, const ProjectOptions& options)
        : m_curve(curve), m_options(options), m_x0(x0), m_tolerance(options.tolerance > 0 ? options.tolerance : 1e-12) {
    }

    CurveProjection run() {
        m_y = m_x0;
        m_at = evaluate(m_y);
        if (!m_at.usable() && !recover())
            return result(m_at.status);
        for (m_iterations = 1; m_iterations <= m_options.maxIterations; ++m_iterations) {
            const Vec3d way = target() - m_y;
            if (length(way) <= smallest())
                return settled();
            relax(way);
            if (!advance(m_y + way * m_part))
                return result(m_at.status);
        }
        m_iterations = m_options.maxIterations;
        return result(Status::NotConverged);
    }

  private:
    Need iterationNeed() const { return m_options.projector == Projector::Orthogonal ? Need::Gradient : Need::Value; }
    CurveEvaluation evaluate(const Vec3d& y) const { return evaluateCurve(m_curve, y, iterationNeed()); }

    double smallest() const {
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        return std::max(m_tolerance * m_at.unit, epsilon * (2 * length(m_y) + 8 * length(m_x0 - m_y)));
    }

    /// basic: y - F. almost: the point of the line through c along t nearest to x0. orthogonal: x0 minus the least step
    /// that takes F linearised at y to zero, x0 - A^T (A A^T)^-1 (F + A (x0 - y)) with A = N^T DF.
    Vec3d target() const {
        if (m_options.projector == Projector::Basic)
            return m_y - m_at.value;
        const Vec3d& t = m_at.direction;
        if (m_options.projector == Projector::Almost)
            return m_at.centroid + t * dot(t, m_x0 - m_at.centroid);
        const Vec3d u = base::perpendicular(t), v = cross(t, u);
        const base::Mat3d down = transposed(m_at.gradient);
        const Vec3d a = down * u, b = down * v, back = m_x0 - m_y;
        const double aa = lengthSq(a), ab = dot(a, b), bb = lengthSq(b), det = aa * bb - ab * ab;
        if (!(det > 1e-4 * aa * bb)) // a gradient that says nothing: the frame's own direction may lead on
            return m_at.centroid + t * dot(t, m_x0 - m_at.centroid);
        const double fu = dot(u, m_at.value) + dot(a, back), fv = dot(v, m_at.value) + dot(b, back);
        return m_x0 - (a * (bb * fu - ab * fv) + b * (aa * fv - ab * fu)) * (1 / det);
    }

    /// The part of the way to go, from two ways in a row [Irons69]; halved where they hardly shrink.
    void relax(const Vec3d& way) {
        if (m_iterations > 1 && m_options.projector != Projector::Basic) {
            const Vec3d change = way - m_lastWay;
            if (lengthSq(change) > 0)
                m_part *= -dot(m_lastWay, change) / lengthSq(change);
            m_slow = length(way) > 0.9 * length(m_lastWay) ? m_slow + 1 : 0;
            if (m_slow >= 2) {
                m_most *= 0.5;
                m_slow = 0;
            }
            m_part = std::clamp(m_part, std::min(0.1, m_most), m_most);
        }
        m_lastWay = way;
    }

    bool advance(Vec3d y1) {
        CurveEvaluation at;
        for (int halvings = 0; halvings < 8; ++halvings, y1 = (m_y + y1) * 0.5) {
            at = evaluate(y1);
            if (!at.usable())
                continue;
            m_y = y1;
            m_at = at;
            return true;
        }
        m_at = at;
        return false;
    }

    /// Outside all supports (surface/README 3.3): from the nearest surfel on.
    bool recover() {
        std::vector<tree::Neighbour> nearest;
        m_curve.tree().nearest(base::cast<float>(m_x0), 1, nearest);
        if (nearest.empty())
            return false;
        m_y = base::cast<double>(nearest[0].block->position(nearest[0].slot));
        m_at = evaluate(m_y);
        return m_at.usable();
    }

    CurveProjection settled() {
        if (length(m_at.value) > 10 * smallest())
            return result(Status::NotConverged);
        if (m_options.need > iterationNeed())
            m_at = evaluateCurve(m_curve, m_y, m_options.need);
        const bool beyond = m_at.status == Status::BeyondBoundary && m_options.checkBoundary;
        return result(beyond ? Status::BeyondBoundary : m_at.usable() ? Status::Ok : m_at.status);
    }

    CurveProjection result(Status status) const { return {status, m_y, m_at, m_iterations}; }

    const Surface& m_curve;
    const ProjectOptions& m_options;
    Vec3d m_x0, m_y, m_lastWay;
    double m_tolerance;
    CurveEvaluation m_at;
    double m_part = 1, m_most = 1.5;
    int m_slow = 0, m_iterations = 0;
};

} // namespace

CurveProjection projectOnCurve(const Surface& curve, const Vec3d& x, const ProjectOptions& options) {
    return CurveProjecting(curve, x, options).run();
}

} // namespace surface
