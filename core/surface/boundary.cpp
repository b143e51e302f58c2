#include "core/surface/boundary.h"

#include "core/surface/assemble.h"

#include <algorithm>

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

Conditions conditionsAt(const Surface& surface, const Vec3d& x, const Hint& hint) {
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
class RimNewton {
  public:
    RimNewton(const Surface& surface, const Vec3d& start, const Hint& hint)
        : m_surface(surface), m_unoriented(!surface.tree().layout()->oriented), m_hint(hint), m_x(start) {}

    RimSearch run() {
        RimSearch out;
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

    RimPoint point() const { return {m_x, base::normalized(m_here.at.gradient), m_outward, m_here.at.unit}; }

    const Surface& m_surface;
    bool m_unoriented;
    Hint m_hint; ///< the one given; for frames without a sign the last normal
    Vec3d m_x, m_outward;
    Conditions m_here;
};

/// One direction of traceRim.
class Tracing {
  public:
    Tracing(const Surface& surface, const RimPoint& seed, double sense, const TraceOptions& options)
        : m_surface(surface), m_options(options), m_sense(sense), m_at(seed),
          m_step(0.25 * options.longestStep * seed.unit) {}

    /// Appends points to the seed until the rim closes (true) or ends. Where f has a step, the way from the seed may
    /// lead into a loop that does not come back to it: then the loop alone is kept (found as Brent 1980 finds cycles).
    bool run(std::vector<RimPoint>& out) {
        std::size_t mark = 0, nextMark = 64;
        while (out.size() < m_options.mostPoints) {
            RimPoint next;
            if (!go(next))
                return false;
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
    Vec3d along(const RimPoint& p) const { return p.tangent() * m_sense; }

    /// The sign of frames that have none. Others are asked as everybody asks them.
    Hint hint() const { return m_surface.tree().layout()->oriented ? Hint{} : Hint{base::cast<float>(m_at.normal)}; }

    /// The next point, half as far as often as it takes to find it where the rim was heading; else farther, over the
    /// steps that f has where near sheets meet.
    bool go(RimPoint& next) {
        const double first = m_step;
        for (; m_step > m_options.shortestStep * m_at.unit; m_step *= 0.5)
            if (leadsOn(next))
                return true;
        for (m_step = 2 * first; m_step <= m_options.longestStep * m_at.unit; m_step *= 2)
            if (leadsOn(next))
                return true;
        return false;
    }

    bool leadsOn(RimPoint& next) const {
        const RimSearch found = findRimPoint(m_surface, m_at.position + along(m_at) * m_step, hint());
        if (!found.ok())
            return false;
        next = found.point;
        const Vec3d way = next.position - m_at.position;
        const double gone = length(way);
        return gone > 0.5 * m_step && gone < 1.5 * m_step && angle(along(m_at), along(next)) < 4 * m_options.turn &&
               dot(way, along(m_at)) > 0.9 * gone && dot(next.normal, m_at.normal) > 0.5;
    }

    /// By the curvature just seen, at most twice as far as before.
    void choose(const RimPoint& next) {
        const double gone = distance(next.position, m_at.position), turned = angle(along(m_at), along(next));
        const double wanted = m_options.turn * gone / std::max(turned, 1e-6);
        m_step = std::clamp(wanted, 4 * m_options.shortestStep * next.unit,
                            std::min(2 * m_step, m_options.longestStep * next.unit));
    }

    /// Whether `mark` lies between the current point and the next.
    bool passes(const RimPoint& mark, const RimPoint& next) const {
        const Vec3d way = next.position - m_at.position, home = mark.position - m_at.position;
        const double part = dot(home, way) / lengthSq(way);
        return part > 0 && part <= 1 && length(home - way * part) < 0.25 * length(way) &&
               dot(along(next), along(mark)) > 0.5 && dot(next.normal, mark.normal) > 0.5;
    }

    static double angle(const Vec3d& a, const Vec3d& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

    const Surface& m_surface;
    const TraceOptions& m_options;
    double m_sense; ///< 1 along the tangents, -1 against them
    RimPoint m_at;
    double m_step;
};

} // namespace

RimSearch findRimPoint(const Surface& surface, const Vec3d& start, const Hint& hint) {
    if (!std::isfinite(surface.definition().boundaryLimit))
        return {Status::NotConverged, {}, 0};
    return RimNewton(surface, start, hint).run();
}

double Rim::length() const {
    double sum = 0;
    for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
        const RimPoint &a = points[i == 0 ? points.size() - 1 : i - 1], &b = points[i];
        const Vec3d s = a.tangent(), t = b.tangent();
        const double half = 0.5 * std::atan2(base::length(cross(s, t)), dot(s, t));
        sum += distance(a.position, b.position) * (half > 1e-6 ? half / std::sin(half) : 1);
    }
    return sum;
}

Rim traceRim(const Surface& surface, const RimPoint& seed, const TraceOptions& options) {
    Rim out;
    out.points.push_back(seed);
    out.closed = Tracing(surface, seed, 1, options).run(out.points);
    if (out.closed)
        return out;
    std::vector<RimPoint> before{seed};
    if (Tracing(surface, seed, -1, options).run(before)) { // a loop, as it is the other way round
        std::reverse(before.begin(), before.end());
        return {std::move(before), true, 0};
    }
    std::reverse(before.begin(), before.end());
    before.insert(before.end(), out.points.begin() + 1, out.points.end());
    out.points = std::move(before);
    return out;
}

} // namespace surface
