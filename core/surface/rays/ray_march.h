// The first root in an interval of a ray: marching with transported sign (surface/README 4.3), in the fast policy with
// sphere tracing and plane iteration. Internal to the room.
#pragma once

#include "core/surface/rays/ray_roots.h"

namespace surface {

template <class T>
class RayMarch {
  public:
    explicit RayMarch(RayProbe<T>& probe) : m_probe(probe), m_setting(probe.setting()) {}

    /// The first hit in [begin, end]. `unit` is the least h met there. Of a ray `leaving` the surface at `begin` the
    /// start counts as being on the side that the ray goes to.
    std::optional<RayHit<T>> first(double begin, double end, double unit, bool leaving = false) {
        m_unit = unit;
        m_probe.expect(end, unit);
        RaySample<T> before, last = m_probe.sample(begin);
        bool iterate = m_setting.trace;
        if (leaving && departs(last))
            iterate = false;
        for (;;) {
            if (iterate && last.usable())
                if (const auto root = planeIteration(m_probe, last, end))
                    if (const auto hit = accept(m_probe, *root))
                        return hit;
            iterate = m_setting.trace;
            if (last.t >= end && !follows(last, end, begin))
                return std::nullopt;
            const double t = std::min(last.t + stepAfter(last, end - begin), end);
            const RaySample<T> next = m_probe.sampleBeside(last, t);
            if (const auto hit = inDip(before, last, next, dips))
                return hit;
            if (const auto hit = between(last, next, splits))
                return hit;
            before = last;
            last = next;
        }
    }

  private:
    static constexpr int splits = 4, dips = 2;  ///< how often intervals are divided for a reason
    static constexpr double steadyCosine = 0.7; ///< unoriented normals must agree this well to carry a sign across

    /// A start on the surface gets the sign of the side that the ray goes to.
    bool departs(RaySample<T>& s) const {
        const double epsilon = secondaryEpsilon * spacingOfUnit * double(s.at.unit);
        if (!s.usable() || std::abs(s.f()) > epsilon)
            return false;
        s.at.value = static_cast<T>(std::copysign(epsilon, s.slope(m_probe.direction()))) * s.sign;
        return true;
    }

    /// From a disc that is crossed at a flat angle it may be far to the surface: goes on while the ray comes closer to
    /// a surface that is near already.
    bool follows(const RaySample<T>& last, double& end, double begin) {
        constexpr double near = 0.2, further = 0.5, most = 10; // of h
        const double unit = double(last.at.unit), still = std::min(end + further * unit, m_probe.mostT());
        if (!m_setting.discs || !last.usable() || !(still > end) || end > begin + most * unit ||
            std::abs(last.f()) > near * unit || last.f() * last.slope(m_probe.direction()) > 0)
            return false;
        end = still;
        m_probe.expect(end, m_unit);
        return true;
    }

    double stepAfter(const RaySample<T>& last, double span) const {
        constexpr double outside = 0.25;   // of h: the bounds end 0.3 h before all weight does
        constexpr double march = 1.0 / 14; // of h: a quarter of the spacing, and half of it with dips looked for
        constexpr double fast = 1.0 / 7;
        constexpr double traceFactor =
            0.85; // |g| stays below 1.05 up to 0.7 h: never jumps a root (surface/README 4.3)
        if (last.at.status == Status::Outside)
            return outside * m_unit;
        const double unit = last.at.unit > T(0) ? double(last.at.unit) : m_unit;
        const double most = m_setting.trace ? fast : march;
        const double step = std::min(most * unit, std::max(span / 4, 1e-6 * unit));
        return m_setting.trace && last.usable() ? std::max(step, traceFactor * std::abs(last.f())) : step;
    }

    /// The first hit between two samples, splitting where the frame fails or turns too fast.
    std::optional<RayHit<T>> between(const RaySample<T>& a, const RaySample<T>& b, int levels) {
        if (!a.usable() || !b.usable()) {
            const bool fails =
                (a.usable() || b.usable()) && a.at.status != Status::Outside && b.at.status != Status::Outside;
            return fails && levels > 0 ? split(a, b, 0.5 * (a.t + b.t), levels) : std::nullopt;
        }
        if (!m_setting.oriented && levels > 0 && std::abs(double(dot(a.at.normal, b.at.normal))) < steadyCosine)
            return split(a, b, 0.5 * (a.t + b.t), levels);
        if ((a.f() < 0) != (b.f() < 0))
            return m_setting.refine ? refined(a, b) : crossed(a, b);
        return passesThrough(a, b) ? atTurn(a, b) : std::nullopt;
    }

    /// Between near sheets and about sharp parts f tells of the nearest sheet alone: where normals turn between two
    /// samples on one side, and the plane at one of them is crossed between them, the ray may have been on the other.
    bool passesThrough(const RaySample<T>& a, const RaySample<T>& b) const {
        constexpr double turned = 0.9; // cosine of the normals at most
        if (!m_setting.oriented || double(dot(a.at.normal, b.at.normal)) >= turned)
            return false;
        const base::Vec3d& d = m_probe.direction();
        const double span = b.t - a.t, down = a.slope(d) * (a.f() < 0 ? 1 : -1), up = b.slope(d) * (b.f() < 0 ? -1 : 1);
        return std::abs(a.f()) < down * span || std::abs(b.f()) < up * span;
    }

    /// The first hit about the place where f goes over from one sheet to the other: if either is crossed, then next to
    /// it.
    std::optional<RayHit<T>> atTurn(RaySample<T> a, RaySample<T> b) {
        constexpr int halvings = 6;
        for (int i = 0; i < halvings; ++i) {
            const RaySample<T> c = m_probe.sampleBeside(a, 0.5 * (a.t + b.t));
            if (!c.usable())
                return std::nullopt;
            if ((c.f() < 0) != (a.f() < 0)) {
                const auto hit = between(a, c, 0);
                return hit ? hit : between(c, b, 0);
            }
            (dot(c.at.normal, a.at.normal) > dot(c.at.normal, b.at.normal) ? a : b) = c;
        }
        return std::nullopt;
    }

    /// The first hit about the lowest of three samples on one side: the ray may pass through a sheet and out again
    /// between them. Looks where a parabola through them is lowest, and once more.
    std::optional<RayHit<T>> inDip(const RaySample<T>& a, const RaySample<T>& b, const RaySample<T>& c, int levels) {
        constexpr double low = 0.1; // of h: what falls and rises about a zero by steps of a fraction of h is lower
        if (levels == 0 || !a.usable() || !b.usable() || !c.usable())
            return std::nullopt;
        const double side = b.f() < 0 ? -1 : 1, fa = side * a.f(), fb = side * b.f(), fc = side * c.f();
        if (!(fa > fb && fc > fb && fb < low * double(b.at.unit)))
            return std::nullopt;
        const double ab = b.t - a.t, bc = c.t - b.t, down = (fa - fb) / ab, up = (fc - fb) / bc;
        const double t = b.t + 0.5 * (down * bc - up * ab) / (down + up);
        const bool early = t < b.t;
        const RaySample<T> middle = m_probe.sampleBeside(b, t);
        if (const auto hit = between(early ? a : b, middle, splits))
            return hit;
        if (const auto hit = between(middle, early ? b : c, splits))
            return hit;
        if (side * middle.f() < fb)
            return inDip(early ? a : b, middle, early ? b : c, levels - 1);
        return inDip(early ? middle : a, b, early ? c : middle, levels - 1);
    }

    std::optional<RayHit<T>> split(const RaySample<T>& a, const RaySample<T>& b, double t, int levels) {
        const RaySample<T> middle = m_probe.sampleBeside(a.usable() ? a : b, t);
        if (const auto hit = between(a, middle, levels - 1))
            return hit;
        RaySample<T> after = b;
        m_probe.align(middle, after);
        return between(middle, after, levels - 1);
    }

    std::optional<RayHit<T>> refined(const RaySample<T>& a, const RaySample<T>& b) {
        const auto root = bracketed(m_probe, a, b);
        return root ? accept(m_probe, *root) : std::nullopt;
    }

    /// The linear estimate, if the surface is there.
    std::optional<RayHit<T>> crossed(const RaySample<T>& a, const RaySample<T>& b) {
        const double t = a.t + (b.t - a.t) * a.f() / (a.f() - b.f());
        const Evaluation<T> at = m_probe.sample(t, Need::Gradient).at;
        // a jump of f keeps a value on both sides; a root has none half-way
        if (!isSurface(at) || std::abs(double(at.value)) > 0.5 * std::max(std::abs(a.f()), std::abs(b.f())))
            return refined(a, b);
        if (!m_probe.inRange(t))
            return std::nullopt;
        return hitAt(m_probe, t, at, at.gradient);
    }

    RayProbe<T>& m_probe;
    const RaySetting& m_setting;
    double m_unit = 0;
};

} // namespace surface
