#include "core/surface/curves/boundary.h"

#include "core/surface/curves/curve_tracing.h"
#include "core/surface/evaluation/assemble.h"
#include "core/surface/rims.h"

namespace surface {

using base::Vec3d;

namespace {

constexpr int maxIterations = 30;
constexpr double tolerance = 1e-12; ///< of the last step, in units of h
constexpr double longestStep = 0.3; ///< of Newton's, in units of h
constexpr double leastSlope = 1e-3; ///< of o^2 along the surface, in units of h: without it o leads nowhere

/// f and e = o^2 - (L h)^2 with their gradients.
struct Conditions {
    Evaluationd at;
    double excess = 0; ///< e
    Vec3d slope;       ///< grad e = 2 (I - J)^T (x - c) - 2 L^2 h grad h

    bool usable() const { return at.ok() || at.status == Status::BeyondBoundary; }
};

Conditions conditionsAt(const Surface& surface, const Vec3d& x, const OrientationHint& hint) {
    Source source(surface);
    ScratchClusters clusters;
    source.gather(x, clusters.list());
    Assembler<double, 1> assembler(source, clusters.span(), x, hint);
    Conditions out;
    out.at = assembler.run();
    if (!out.usable())
        return out;
    const Vec3d d = x - out.at.centroid;
    const double limit = static_cast<double>(surface.definition().boundaryLimit), reach = limit * out.at.unit;
    out.excess = lengthSq(d) - reach * reach;
    out.slope = (d - transposed(assembler.centroidGradient()) * d - assembler.unitGradient() * (limit * reach)) * 2;
    return out;
}

/// Newton's iteration of the header.
class BoundaryNewton {
  public:
    BoundaryNewton(const Surface& surface, const Vec3d& start, const OrientationHint& hint)
        : m_surface(surface), m_unoriented(!surface.tree().layout()->oriented), m_hint(hint), m_x(start) {}

    BoundarySearch run() {
        BoundarySearch out;
        evaluate();
        for (; m_here.usable(); ++out.iterations) {
            const Vec3d step = next();
            const double size = length(step), unit = m_here.at.unit;
            out.status = Status::NotConverged;
            if (!(size > std::max(tolerance * unit, 4e-16 * length(m_x)))) {
                if (std::isfinite(size) && std::abs(m_here.at.value) <= 1e-9 * unit) {
                    out.status = Status::Ok;
                    out.point = point();
                }
                return out;
            }
            if (out.iterations == maxIterations)
                return out;
            if (!advance(size > longestStep * unit ? step * (longestStep * unit / size) : step))
                break;
        }
        out.status = m_here.at.status;
        return out;
    }

  private:
    /// dy = a g + b t with g.dy = -f and grad e.dy = -e, t the part of grad e along the surface.
    Vec3d next() {
        const Vec3d& g = m_here.at.gradient;
        const double gg = lengthSq(g), unit = m_here.at.unit;
        const Vec3d along = m_here.slope - g * (dot(m_here.slope, g) / gg);
        const double steep = length(along);
        m_outward = along / steep;
        if (!(gg > 0) || !(steep > leastSlope * unit))
            return m_outward * std::numeric_limits<double>::quiet_NaN();
        const double a = -m_here.at.value / gg;
        return g * a + m_outward * ((-m_here.excess - a * dot(m_here.slope, g)) / steep);
    }

    bool advance(Vec3d step) {
        const Vec3d before = m_x;
        for (int halvings = 0; halvings < 8; ++halvings, step *= 0.5) {
            m_x = before + step;
            evaluate();
            if (m_here.usable())
                return true;
        }
        return false;
    }

    void evaluate() {
        m_here = conditionsAt(m_surface, m_x, m_hint);
        if (m_unoriented && m_here.usable()) // keep the sign
            m_hint.direction = base::cast<float>(m_here.at.normal);
    }

    BoundaryPoint point() const { return {m_x, base::normalized(m_here.at.gradient), m_outward, m_here.at.unit}; }

    const Surface& m_surface;
    bool m_unoriented;
    OrientationHint m_hint; ///< the one given; for frames without a sign the last normal
    Vec3d m_x, m_outward;
    Conditions m_here;
};

struct BoundaryProblem {
    using Point = BoundaryPoint;
    const Surface& of;

    const Surface& surface() const { return of; }
    std::optional<BoundaryPoint> find(const Vec3d& start, const OrientationHint& hint) const {
        const BoundarySearch found = findBoundaryPoint(of, start, hint);
        return found.ok() ? std::optional(found.point) : std::nullopt;
    }
    static bool holds(const BoundaryPoint&) { return true; } // `find` has asked
};

} // namespace

BoundarySearch findBoundaryPoint(const Surface& surface, const Vec3d& start, const OrientationHint& hint) {
    if (!std::isfinite(surface.definition().boundaryLimit))
        return {Status::NotConverged, {}, 0};
    BoundarySearch out = BoundaryNewton(surface, start, hint).run();
    if (out.ok() && !mayEnd(surface, out.point.position))
        out.status = Status::NotConverged; // off centre, as at a fold, and no rim
    return out;
}

double BoundaryCurve::length() const {
    return arcLength(points, closed);
}

BoundaryCurve traceBoundary(const Surface& surface, const BoundaryPoint& seed, const TraceOptions& options) {
    auto [points, closed] = traceCurve(BoundaryProblem{surface}, seed, options);
    return {std::move(points), closed, 0};
}

} // namespace surface
