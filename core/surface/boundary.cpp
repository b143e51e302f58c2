#include "core/surface/boundary.h"

#include "core/surface/assemble.h"

#include <algorithm>

namespace surface {

using base::Vec3d;

namespace {

constexpr int maxIterations = 30;
constexpr double tolerance = 1e-12; ///< of the last step, in units of h
constexpr double longestStep = 0.3; ///< of Newton's, in units of h
constexpr double leastSlope = 1e-3; ///< of o along the surface: without it o leads nowhere

/// f and o^2 - (L h)^2 with their gradients, but for that of h, which only neighbours can tell.
struct Conditions {
    Evaluationd at;
    Vec3d slope; ///< grad o^2

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
    out.slope = (d - transposed(assembler.centroidGradient()) * d) * 2;
    return out;
}

/// Newton's iteration of the header.
class RimNewton {
  public:
    RimNewton(const Surface& surface, const Vec3d& start, const Hint& hint)
        : m_surface(surface), m_limit(static_cast<double>(surface.definition().boundaryLimit)), m_hint(hint),
          m_x(start) {}

    RimSearch run() {
        RimSearch out;
        m_here = conditionsAt(m_surface, m_x, m_hint);
        for (; m_here.usable(); ++out.iterations) {
            m_hint.direction = base::cast<float>(m_here.at.normal);
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
    /// dy = a g + b t with g.dy = -f and grad O.dy = -O, t the part of grad O along the surface.
    Vec3d next() {
        const Vec3d& g = m_here.at.gradient;
        const double gg = lengthSq(g), unit = m_here.at.unit, reach = m_limit * unit;
        m_outward = m_here.slope - g * (dot(m_here.slope, g) / gg);
        const double steep = length(m_outward);
        const double excess = m_here.at.offCentre * m_here.at.offCentre - reach * reach;
        m_outward = m_outward / steep;
        const double gain = steep - 2 * m_limit * reach * m_unitSlope;
        if (!(gg > 0) || !(gain > leastSlope * reach))
            return m_outward * std::numeric_limits<double>::quiet_NaN();
        const double a = -m_here.at.value / gg;
        return g * a + m_outward * ((-excess - a * dot(m_here.slope, g)) / gain);
    }

    bool advance(Vec3d step) {
        const Vec3d before = m_x, outward = m_outward;
        const double unit = m_here.at.unit;
        for (int halvings = 0; halvings < 8; ++halvings, step *= 0.5) {
            m_x = before + step;
            m_here = conditionsAt(m_surface, m_x, m_hint);
            if (!m_here.usable())
                continue;
            const double along = dot(step, outward); // the slope of h as the step has shown it
            if (std::abs(along) > 1e-9 * unit)
                m_unitSlope = std::clamp((m_here.at.unit - unit) / along, -0.5, 0.5);
            return true;
        }
        return false;
    }

    RimPoint point() const { return {m_x, base::normalized(m_here.at.gradient), m_outward, m_here.at.unit}; }

    const Surface& m_surface;
    double m_limit;
    Hint m_hint; ///< keeps the sign of frames that have none
    Vec3d m_x, m_outward;
    Conditions m_here;
    double m_unitSlope = 0;
};

/// One direction of traceRim.
class Tracing {
  public:
    Tracing(const Surface& surface, const RimPoint& seed, double sense, const TraceOptions& options)
        : m_surface(surface), m_options(options), m_sense(sense), m_seed(seed), m_at(seed),
          m_step(0.25 * options.longestStep * seed.unit) {}

    /// Appends points until the rim closes (true) or ends.
    bool run(std::vector<RimPoint>& out) {
        const std::size_t first = out.size();
        while (out.size() < m_options.mostPoints) {
            RimPoint next;
            if (!go(next))
                return false;
            if (out.size() > first + 1 && passesSeed(next))
                return true;
            out.push_back(next);
            choose(next);
            m_at = next;
        }
        return false;
    }

  private:
    Vec3d along(const RimPoint& p) const { return p.tangent() * m_sense; }

    /// The next point, half as far as often as it takes to find it where the rim was heading.
    bool go(RimPoint& next) {
        for (; m_step > m_options.shortestStep * m_at.unit; m_step *= 0.5) {
            const RimSearch found =
                findRimPoint(m_surface, m_at.position + along(m_at) * m_step, {base::cast<float>(m_at.normal)});
            if (!found.ok())
                continue;
            next = found.point;
            const Vec3d way = next.position - m_at.position;
            const double gone = length(way), turned = angle(along(m_at), along(next));
            if (gone > 0.5 * m_step && gone < 1.5 * m_step && turned < 4 * m_options.turn &&
                dot(way, along(m_at)) > 0.9 * gone && dot(next.normal, m_at.normal) > 0.5)
                return true;
        }
        return false;
    }

    /// By the curvature just seen, at most twice as far as before.
    void choose(const RimPoint& next) {
        const double gone = distance(next.position, m_at.position), turned = angle(along(m_at), along(next));
        const double wanted = m_options.turn * gone / std::max(turned, 1e-6);
        m_step = std::clamp(wanted, 4 * m_options.shortestStep * next.unit,
                            std::min(2 * m_step, m_options.longestStep * next.unit));
    }

    /// Whether the seed lies between the current point and the next.
    bool passesSeed(const RimPoint& next) const {
        const Vec3d way = next.position - m_at.position, home = m_seed.position - m_at.position;
        const double part = dot(home, way) / lengthSq(way);
        return part > 0 && part <= 1 && length(home - way * part) < 0.25 * length(way) &&
               dot(along(next), along(m_seed)) > 0.5 && dot(next.normal, m_seed.normal) > 0.5;
    }

    static double angle(const Vec3d& a, const Vec3d& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

    const Surface& m_surface;
    const TraceOptions& m_options;
    double m_sense; ///< 1 along the tangents, -1 against them
    RimPoint m_seed, m_at;
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
    std::vector<RimPoint> before;
    Tracing(surface, seed, -1, options).run(before);
    std::reverse(before.begin(), before.end());
    out.points.insert(out.points.begin(), before.begin(), before.end());
    return out;
}

} // namespace surface
