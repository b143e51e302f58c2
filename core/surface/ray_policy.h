// One ray by either policy: from surface bounds or discs to hits (alg. 3.2). Internal to the room.
#pragma once

#include "core/surface/ray_march.h"
#include "core/surface/surface_intervals.h"

namespace surface {

template <class T>
class RayPolicy {
  public:
    /// `known` may hold the discs met from tMin on, of a ray that starts outside the setting's bounds.
    RayPolicy(const RaySetting& setting, RaySources& sources, const base::Ray<T>& ray, const DiscHit* known = nullptr)
        : m_setting(setting), m_probe(setting, sources, ray), m_known(known), m_march(m_probe) {}

    RayHit<T> first() {
        const auto hit = valid() ? next(m_setting.options.tMin, false) : std::nullopt;
        return hit ? *hit : missed();
    }
    std::vector<RayHit<T>> all() {
        std::vector<RayHit<T>> out;
        auto hit = valid() ? next(m_setting.options.tMin, false) : std::nullopt;
        for (; hit; hit = next(past(*hit), true))
            out.push_back(*hit);
        return out;
    }
    bool any() { return valid() && next(double(m_setting.options.tMin), true).has_value(); }

  private:
    bool valid() const { return m_setting.any && lengthSq(m_probe.direction()) > 0; }
    RayHit<T> missed() {
        RayHit<T> out;
        out.evaluations = m_probe.takeEvaluations();
        return out;
    }
    /// Far enough behind a hit to find the next.
    double past(const RayHit<T>& hit) const {
        const double size = length(m_probe.position(double(hit.t)));
        const double rounding = 4 * double(std::numeric_limits<float>::epsilon()) * size;
        return double(hit.t) + std::max(secondaryEpsilon * spacingOfUnit * double(hit.unit), rounding);
    }

    std::optional<RayHit<T>> next(double from, bool leaving) {
        return m_setting.discs ? byDiscs(from, leaving) : byBounds(from, leaving);
    }

    std::optional<RayHit<T>> byBounds(double from, bool leaving) {
        std::optional<RayHit<T>> out;
        forSurfaceIntervals(m_setting.surface, m_probe.rounded(), from, m_setting.options.tMax,
                            [&](const SurfaceInterval& i) {
                                out = m_march.first(i.begin, i.end, i.unit, leaving && i.begin == from);
                                return !out;
                            });
        return out;
    }

    /// From disc to disc; what a doubtful one might hide is marched.
    std::optional<RayHit<T>> byDiscs(double from, bool leaving) {
        constexpr double before = 0.5, behind = 1.0; // of h: the surface about a disc's crossing, along grazing rays
        if (const auto hit = nearStart(from, leaving))
            return hit;
        while (from <= double(m_setting.options.tMax)) {
            const DiscHit disc = nearest(from);
            if (!disc.crossed() && !disc.brushed())
                break;
            if (!disc.doubtful())
                if (const auto hit = atDisc(disc, from))
                    return hit;
            const double unit = unitOf(m_setting.surface.definition().weight, disc.reach());
            const double begin = std::max(from, double(disc.first()) - before * unit);
            const double end = std::min(double(disc.last()) + behind * unit, double(m_setting.options.tMax));
            if (const auto hit = m_march.first(begin, end, unit))
                return hit;
            from = std::max(end, std::nextafter(from, std::numeric_limits<double>::infinity()));
            if (!(end < double(m_setting.options.tMax)))
                break;
        }
        return std::nullopt;
    }

    DiscHit nearest(double from) {
        if (const DiscHit* known = std::exchange(m_known, nullptr))
            return *known;
        const base::Rayf ray = m_probe.rounded();
        DiscHit out;
        nearestDiscs(m_setting.surface.tree(), {&ray, 1},
                     {static_cast<float>(from), m_setting.options.tMax, m_setting.maxSupport}, {&out, 1});
        return out;
    }

    std::optional<RayHit<T>> atDisc(const DiscHit& disc, double from) {
        auto hit = polished(m_probe, double(disc.guess), double(disc.cosine));
        return hit && double(hit->t) >= from ? hit : std::nullopt;
    }

    /// Starting near the surface there may be a root with its discs behind: marches until it is left, and moves `from`
    /// there.
    std::optional<RayHit<T>> nearStart(double& from, bool leaving) {
        constexpr double reach = 0.8; // of h
        if (m_known || !m_setting.bounds.contains(base::cast<float>(m_probe.position(from))))
            return std::nullopt;
        const Evaluation<T> at = m_probe.guess(from);
        if (at.status == Status::Outside)
            return std::nullopt;
        const double unit = at.unit > T(0) ? double(at.unit) : double(m_setting.maxSupport);
        const double end = std::min(from + reach * unit, double(m_setting.options.tMax));
        const auto hit = m_march.first(from, end, unit, leaving);
        from = end;
        return hit;
    }

    const RaySetting& m_setting;
    RayProbe<T> m_probe;
    const DiscHit* m_known;
    RayMarch<T> m_march;
};

} // namespace surface
