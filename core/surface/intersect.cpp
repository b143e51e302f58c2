#include "core/surface/intersect.h"

#include "core/base/parallel.h"
#include "core/surface/source.h"

#include <cassert>
#include <optional>

namespace surface {

namespace {

constexpr double marchStep = 1.0 / 14; ///< of h: a quarter of the spacing at h = 3.5 s
constexpr double traceFactor = 0.85;   ///< |g| stays below 1.05 up to 0.7 h: 0.85 |f| never jumps a root (alg. 3.2.3)
constexpr double planeBand = 0.5;      ///< of h: within it, plane iteration goes straight for the root
constexpr double planeSlope = 0.25;    ///< |n.d| below which the ray grazes and is marched
/// Of h: without weight all surfels are 0.98 h away, and the surface within 0.7 h of some (surfaceReach).
constexpr double outsideStep = 0.25;
constexpr double mergeSlack = 0.25;                   ///< of the support: intervals this close are one
constexpr double steadyCosine = 0.7;                  ///< normals of consecutive unoriented points must agree this well
constexpr double aheadReach = 1.5, aheadSlack = 0.15; ///< of h, along the ray and around it
constexpr int refinements = 60;

/// One ray against the surface. `t` is double in both precisions: positions are rounded once, where f is asked for.
template <class T>
class Casting {
  public:
    Casting(Source& source, const base::Ray<T>& ray, const IntersectOptions& options)
        : m_source(source), m_surface(source.surface()), m_origin(base::cast<double>(ray.origin)),
          m_direction(base::normalized(base::cast<double>(ray.direction))), m_options(options),
          m_oriented(m_surface.tree().layout()->normals && m_surface.tree().layout()->oriented),
          m_tolerance(std::is_same_v<T, float> ? 1e-6 : 1e-12),
          m_trace(!options.robust && m_surface.effectiveFrame() != Frame::Covariance) {}

    /// Walks the surface bounds front to back, joining those that touch, until an interval holds a hit.
    RayHit<T> run() {
        if (lengthSq(m_direction) == 0)
            return {};
        const base::Rayf ray{base::cast<float>(m_origin), base::cast<float>(m_direction)};
        double begin = 0, end = -1;
        const double least = m_options.tMin, most = m_options.tMax;
        m_surface.tree().alongRay(ray, [&](const surfel::SurfelBlock& block, int cluster, float enter, float leave) {
            const float support = block.bounds(cluster).maxSupport;
            const double slack = mergeSlack * static_cast<double>(support);
            const double from = std::max(enter - slack, least), to = std::min(leave + slack, most);
            if (from > most)
                return false;
            if (to < from)
                return true;
            m_leastUnit = std::min(m_leastUnit, double(unitOf(m_surface.definition().weight, support)));
            if (end < begin) {
                begin = from, end = to;
            } else if (from <= end) {
                end = std::max(end, to);
            } else {
                if (walk(begin, end))
                    return false;
                begin = from, end = to;
            }
            return true;
        });
        if (!m_hit.hit && begin <= end)
            walk(begin, end);
        m_hit.evaluations = m_evaluations;
        return m_hit;
    }

  private:
    struct Sample {
        double t = 0;
        Evaluation<T> at;
        T sign = 1; ///< transported along the ray where the frame has none of its own

        bool usable() const { return at.ok() || at.status == Status::BeyondBoundary; }
        double f() const { return static_cast<double>(sign * at.value); }
    };

    base::Vec3d position(double t) const { return m_origin + m_direction * t; }

    Sample sample(double t, Need need = Need::Value) const {
        collectAhead(t);
        ++m_evaluations;
        return {t, m_source.evaluate(base::cast<T>(position(t)), need), T(1)};
    }
    /// What the next steps will ask for, collected at once.
    void collectAhead(double t) const {
        if constexpr (std::is_same_v<T, float>) {
            const base::Vec3f here = base::cast<float>(position(t));
            if (m_source.covers(here))
                return;
            base::Box3f box{here, here};
            box.extend(base::cast<float>(position(std::min(t + aheadReach * m_leastUnit, m_end))));
            m_source.expect(box.inflated(static_cast<float>(aheadSlack * m_leastUnit)));
        }
    }
    /// A sample whose normal looks to the same side as that of a neighbour on the ray.
    Sample sampleBeside(const Sample& other, double t) const {
        Sample out = sample(t);
        if (!m_oriented && out.usable()) {
            const T turn = dot(out.at.normal, other.at.normal) * other.sign;
            out.sign = turn < T(0) ? T(-1) : T(1);
        }
        return out;
    }

    double tolerance(const Evaluation<T>& at, double t) const {
        const double size = length(position(t));
        return std::max(m_tolerance * static_cast<double>(at.unit),
                        4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size);
    }

    /// Looks for the first hit in [begin, end]; true where `m_hit` was set.
    bool walk(double begin, double end) {
        m_end = end;
        Sample last = sample(begin);
        while (last.t < end) {
            const double t = std::min(last.t + stepAfter(last, end - begin), end);
            if (m_trace && last.usable()) {
                if (const auto root = planeIteration(last, end); root && accept(*root))
                    return true;
            }
            Sample next = last.usable() ? sampleBeside(last, t) : sample(t);
            if (!last.usable() || !next.usable()) {
                last = next;
                continue;
            }
            if (searchBetween(last, next, 4))
                return true;
            last = next;
        }
        return false;
    }

    double stepAfter(const Sample& last, double span) const {
        if (last.at.status == Status::Outside)
            return outsideStep * m_leastUnit;
        const double unit = last.at.unit > T(0) ? static_cast<double>(last.at.unit) : m_leastUnit;
        const double step = std::min(marchStep * unit, std::max(span / 4, 1e-6 * unit));
        return m_trace && last.usable() ? std::max(step, traceFactor * std::abs(last.f())) : step;
    }

    /// A root between two samples, splitting where unoriented normals turn too fast to carry a sign across.
    bool searchBetween(const Sample& a, const Sample& b, int levels) {
        const double turn = static_cast<double>(std::abs(dot(a.at.normal, b.at.normal)));
        if (!m_oriented && turn < steadyCosine && levels > 0) {
            const Sample middle = sampleBeside(a, 0.5 * (a.t + b.t));
            if (!middle.usable())
                return false;
            Sample after = b;
            after.sign = dot(b.at.normal, middle.at.normal) * middle.sign < T(0) ? T(-1) : T(1);
            return searchBetween(a, middle, levels - 1) || searchBetween(middle, after, levels - 1);
        }
        if ((a.f() < 0) == (b.f() < 0))
            return false;
        const auto root = bracketed(a, b);
        return root && accept(*root);
    }

    /// Illinois' false position on the transported f. Nothing where the frame fails inside.
    std::optional<double> bracketed(Sample a, Sample b) const {
        double fa = a.f(), fb = b.f();
        int moved = 0; // the end that moved last: -1 a, 1 b
        for (int i = 0; i < refinements; ++i) {
            double t = a.t + (b.t - a.t) * fa / (fa - fb);
            if (!(t > a.t && t < b.t))
                t = 0.5 * (a.t + b.t);
            const Sample c = sampleBeside(a, t);
            if (!c.usable())
                return std::nullopt;
            const double fc = c.f(), still = tolerance(c.at, t);
            if (std::abs(fc) <= 0.1 * still || b.t - a.t <= still)
                return t;
            if ((fc < 0) == (fa < 0)) {
                a = c, fa = fc;
                fb *= moved == -1 ? 0.5 : 1;
                moved = -1;
            } else {
                b = c, fb = fc;
                fa *= moved == 1 ? 0.5 : 1;
                moved = 1;
            }
        }
        return std::nullopt;
    }

    /// The iteration of alg. 3.2.2 from a point close to the surface on a ray that does not graze it: exact in a few
    /// steps, and, starting within the band where |f| bounds the distance, at the first root.
    std::optional<double> planeIteration(const Sample& start, double end) const {
        const double band = planeBand * static_cast<double>(start.at.unit);
        if (std::abs(start.f()) > band)
            return std::nullopt;
        Sample s = start;
        double furthest = end;
        for (int i = 0; i < 12; ++i) {
            const double slope = dot(base::cast<double>(s.at.normal) * static_cast<double>(s.sign), m_direction);
            if (std::abs(slope) < planeSlope)
                return std::nullopt;
            const double step = -s.f() / slope;
            if (i == 0 && step < 0)
                return std::nullopt; // the surface lies behind
            const double t = s.t + step, still = tolerance(s.at, s.t);
            if (i == 0)
                furthest = std::min(end, start.t + 1.5 * step) + still;
            if (t < start.t - still || t > furthest)
                return std::nullopt;
            if (std::abs(step) <= still)
                return t;
            s = sampleBeside(s, t);
            if (!s.usable())
                return std::nullopt;
        }
        return std::nullopt;
    }

    /// Is this root surface: valid frame, inside the boundary, |f| small, slope steep enough (intersect.h)?
    bool accept(double t) {
        if (t < m_options.tMin || t > m_options.tMax)
            return false;
        const Sample s = sample(t, Need::Gradient);
        if (!s.at.ok() || static_cast<double>(std::abs(s.at.value)) > 10 * tolerance(s.at, t))
            return false;
        if (!(dot(s.at.normal, s.at.gradient) >= static_cast<T>(minSlope)))
            return false;
        m_hit.hit = true;
        m_hit.t = static_cast<T>(t);
        m_hit.position = base::cast<T>(position(t));
        m_hit.outward = base::normalized(s.at.gradient);
        const bool away = dot(m_hit.outward, base::cast<T>(m_direction)) > T(0);
        m_hit.normal = away ? -m_hit.outward : m_hit.outward;
        m_hit.unit = s.at.unit;
        m_hit.agreement = s.at.agreement;
        return true;
    }

    Source& m_source;
    const Surface& m_surface;
    base::Vec3d m_origin, m_direction;
    const IntersectOptions& m_options;
    bool m_oriented;
    double m_tolerance;
    bool m_trace;
    double m_end = 0;                                             ///< of the interval walked
    double m_leastUnit = std::numeric_limits<double>::infinity(); ///< of the clusters met so far
    mutable int m_evaluations = 0;
    RayHit<T> m_hit;
};

} // namespace

RayHit<float> intersect(const Surface& surface, const base::Rayf& ray, const IntersectOptions& options) {
    Source source(surface);
    return Casting<float>(source, ray, options).run();
}

RayHit<double> intersectReference(const Surface& surface, const base::Rayd& ray, const IntersectOptions& options) {
    Source source(surface);
    return Casting<double>(source, ray, options).run();
}

void intersect(const Surface& surface, std::span<const base::Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out) {
    assert(rays.size() == out.size());
    base::parallelChunks(rays.size(), 64, [&](std::size_t begin, std::size_t end, std::size_t) {
        Source source(surface);
        for (std::size_t i = begin; i < end; ++i)
            out[i] = Casting<float>(source, rays[i], options).run();
    });
}

} // namespace surface
