// One ray by either policy: from surface bounds or discs to hits (surface/README 4). Internal to the room.
#pragma once

#include "core/surface/rays/far_ray.h"
#include "core/surface/rays/ray_march.h"
#include "core/surface/rays/surface_intervals.h"

namespace surface {

template <class T>
class RayPolicy {
  public:
    /// `known` may hold the discs met from tMin on, of a ray that starts outside the setting's bounds.
    RayPolicy(const RaySetting& setting, RaySources& sources, const base::Ray<T>& ray, const DiscHit* known = nullptr)
        : m_far(farRay(setting, ray)), m_setting(m_far ? m_far->setting : setting),
          m_probe(m_setting, sources, m_far ? m_far->ray : ray), m_known(m_far ? nullptr : known), m_march(m_probe) {}

    void first(RayHit<T>& out) {
        if (!valid() || !next(double(m_setting.options.tMin), false, out)) {
            out = {};
            out.evaluations = m_probe.takeEvaluations();
        }
        count(out);
    }
    std::vector<RayHit<T>> all() {
        std::vector<RayHit<T>> out;
        RayHit<T> hit;
        bool more = valid() && next(double(m_setting.options.tMin), false, hit);
        for (; more; more = next(past(hit), true, hit)) {
            out.push_back(hit);
            count(out.back());
        }
        return out;
    }
    bool any() {
        RayHit<T> hit;
        return valid() && next(double(m_setting.options.tMin), true, hit);
    }

    /// Does it begin anew? Then nothing that packets look for together is of use.
    bool far() const { return m_far.has_value(); }

    /// any() about the start, for packets that look for discs together afterwards: is something in the way until the
    /// ray has left what lies about its start? Else `from` is where it has. REQUIRES: discs, and `from` is tMin.
    bool blockedNear(double& from) {
        RayHit<T> hit;
        return valid() && !leavesFreely(from) && nearStart(from, true, hit);
    }

  private:
    /// Distances from where the ray began.
    void count(RayHit<T>& hit) const {
        if (m_far && hit.hit)
            hit.t = static_cast<T>(double(hit.t) + m_far->skipped);
    }
    bool valid() const { return m_setting.any && lengthSq(m_probe.direction()) > 0; }
    /// Far enough behind a hit to find the next: further than its t, which is a T, may lie before it.
    double past(const RayHit<T>& hit) const {
        const double size = std::max(length(m_probe.position(double(hit.t))), double(hit.t));
        const double rounding = 4 * double(std::numeric_limits<float>::epsilon()) * size;
        return double(hit.t) + std::max(secondaryEpsilon * spacingOfUnit * double(hit.unit), rounding);
    }

    /// The first hit from `from` on; `out` means nothing where there is none.
    bool next(double from, bool leaving, RayHit<T>& out) {
        return m_setting.discs ? byDiscs(from, leaving, out) : byBounds(from, leaving, out);
    }
    static bool take(const std::optional<RayHit<T>>& hit, RayHit<T>& out) {
        if (hit)
            out = *hit;
        return hit.has_value();
    }

    bool byBounds(double from, bool leaving, RayHit<T>& out) {
        bool found = false;
        forSurfaceIntervals(m_setting.surface, m_probe.rounded(), from, m_setting.options.tMax,
                            [&](const SurfaceInterval& i) {
                                found = take(m_march.first(i.begin, i.end, i.unit, leaving && i.begin == from), out);
                                return !found;
                            });
        return found;
    }

    /// From disc to disc; what a doubtful one might hide is marched.
    bool byDiscs(double from, bool leaving, RayHit<T>& out) {
        constexpr double before = 0.5, behind = 1.0; // of h: the surface about a disc's crossing, along grazing rays
        if (nearStart(from, leaving, out))
            return true;
        while (from <= double(m_setting.options.tMax)) {
            const DiscHit disc = nearest(from);
            if (!disc.crossed() && !disc.brushed())
                break;
            if (!disc.doubtful() && atDisc(disc, from, out))
                return true;
            const double unit = unitOf(m_setting.surface.definition().weight, disc.reach());
            const double begin = std::max(from, double(disc.first()) - before * unit);
            const double end = std::min(double(disc.last()) + behind * unit, double(m_setting.options.tMax));
            if (begin < end && take(m_march.first(begin, end, unit), out))
                return true;
            from = std::max(end, std::nextafter(from, std::numeric_limits<double>::infinity()));
            if (!(end < double(m_setting.options.tMax)))
                break;
        }
        return false;
    }

    DiscHit nearest(double from) {
        if (const DiscHit* known = std::exchange(m_known, nullptr))
            return *known;
        const base::Rayf ray = m_probe.rounded();
        DiscHit out;
        nearestDiscs(m_setting.surface.tree(), {&ray, 1},
                     {static_cast<float>(from), m_setting.discMost(), m_setting.maxSupport}, {&out, 1});
        return out;
    }

    bool atDisc(const DiscHit& disc, double from, RayHit<T>& out) {
        return polished(m_probe, double(disc.guess), double(disc.cosine), out) && double(out.t) >= from;
    }

    /// Starting near the surface there may be a root with its discs behind: marches until it is left, and moves `from`
    /// there.
    bool nearStart(double& from, bool leaving, RayHit<T>& out) {
        constexpr double reach = 0.8; // of h
        if (m_known || !m_setting.bounds.contains(base::cast<float>(m_probe.position(from))))
            return false;
        const Evaluation<T>& at = m_probe.guess(from);
        if (at.status == Status::Outside || !(at.unit > T(0)))
            return false;
        const double unit = double(at.unit);
        const double end = std::min(from + reach * unit, double(m_setting.options.tMax));
        const bool found = take(m_march.first(from, end, unit, leaving), out);
        from = end;
        return found;
    }

    /// Where one flat sheet lies about the start and the ray leaves it, a look half-way tells as much as a march: f
    /// there is what the sheet says, and so is n. Anything else within reach would show in both, or in the agreement.
    /// Moves `from` to where the march would end.
    bool leavesFreely(double& from) {
        constexpr double half = 0.4;                                         // of h, as far as nearStart reaches
        constexpr double steep = 0.12, off = 0.25, flat = 0.9, alike = 0.95; // slope, of f, cosine, agreement
        if (!m_setting.bounds.contains(base::cast<float>(m_probe.position(from))))
            return false;
        const Evaluation<T>& at = m_probe.guess(from);
        const base::Vec3<T> n = at.normal;
        const double unit = double(at.unit), f = double(at.value);
        const double slope = dot(base::cast<double>(n), m_probe.direction());
        if (!isFlat(at, alike) || std::abs(slope) < steep || f * slope < 0)
            return false;
        const Evaluation<T>& middle = m_probe.guess(from + half * unit);
        const double rise = half * unit * slope, expected = f + rise;
        if (!isFlat(middle, alike) || std::abs(double(middle.value) - expected) > off * std::abs(rise) ||
            double(dot(middle.normal, n)) < flat)
            return false;
        from += 2 * half * unit;
        return true;
    }
    static bool isFlat(const Evaluation<T>& at, double alike) {
        return (at.ok() || at.status == Status::BeyondBoundary) && double(at.agreement) >= alike;
    }

    const std::optional<FarRay<T>> m_far;
    const RaySetting& m_setting; ///< m_far's own, or that of all
    RayProbe<T> m_probe;
    const DiscHit* m_known;
    RayMarch<T> m_march;
};

} // namespace surface
