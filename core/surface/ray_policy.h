// One ray by either policy: from surface bounds or discs to hits (alg. 3.2). Internal to the room.
#pragma once

#include "core/surface/ray_march.h"
#include "core/surface/surface_intervals.h"

namespace surface {

/// Do the surfels have discs that the fast policy may begin at? Needs oriented normals, and a frame that can be
/// iterated (cov is no distance off the surface, alg. 3.2.3).
inline bool hasDiscs(const Surface& surface) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    return layout.normals && layout.oriented && surface.effectiveFrame() != Frame::Covariance;
}

/// Can a ray that starts at x meet the surface only after it has entered the model's bounds?
inline bool isFar(const Surface& surface, const base::Vec3f& x) {
    const float reach = surface.tree().maxSupport();
    return surface.tree().bounds().distanceSq(x) > reach * reach;
}

template <class T>
class RayPolicy {
  public:
    /// `first` may hold the discs met from tMin on, of a ray that starts far from the model.
    RayPolicy(RaySources& sources, const base::Ray<T>& ray, const IntersectOptions& options, bool refine = true,
              const DiscHit* first = nullptr)
        : m_options(refine ? options : coarse(options)), m_probe(sources, ray, m_options), m_known(first),
          m_discs(!options.robust && hasDiscs(m_probe.surface())),
          m_march(m_probe, {!options.robust && m_probe.surface().effectiveFrame() != Frame::Covariance, refine}) {}

    RayHit<T> first() {
        const auto hit = valid() ? next(m_options.tMin, false) : std::nullopt;
        return hit ? *hit : missed();
    }
    std::vector<RayHit<T>> all() {
        std::vector<RayHit<T>> out;
        auto hit = valid() ? next(m_options.tMin, false) : std::nullopt;
        for (; hit; hit = next(past(*hit), true))
            out.push_back(*hit);
        return out;
    }
    bool any() { return valid() && next(double(m_options.tMin), true).has_value(); }

  private:
    /// Where a sign change is enough.
    static IntersectOptions coarse(IntersectOptions options) {
        options.tolerance = std::max(options.tolerance, 0.02);
        return options;
    }
    bool valid() const {
        return lengthSq(m_probe.direction()) > 0 && !m_probe.surface().tree().empty() &&
               m_probe.surface().definition().manifold == Manifold::Surface;
    }
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
        return m_discs ? byDiscs(from, leaving) : byBounds(from, leaving);
    }

    std::optional<RayHit<T>> byBounds(double from, bool leaving) {
        std::optional<RayHit<T>> out;
        forSurfaceIntervals(m_probe.surface(), m_probe.rounded(), from, m_options.tMax, [&](const SurfaceInterval& i) {
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
        while (from <= double(m_options.tMax)) {
            const DiscHit disc = nearest(from);
            if (!disc.crossed() && !disc.brushed())
                break;
            if (!disc.doubtful())
                if (const auto hit = atDisc(disc, from))
                    return hit;
            const double unit = unitOf(m_probe.surface().definition().weight, disc.reach());
            const double begin = std::max(from, double(disc.first()) - before * unit);
            const double end = std::min(double(disc.last()) + behind * unit, double(m_options.tMax));
            if (const auto hit = m_march.first(begin, end, unit))
                return hit;
            from = std::max(end, std::nextafter(from, std::numeric_limits<double>::infinity()));
            if (!(end < double(m_options.tMax)))
                break;
        }
        return std::nullopt;
    }

    DiscHit nearest(double from) {
        if (const DiscHit* known = std::exchange(m_known, nullptr))
            return *known;
        const tree::SurfelTree& tree = m_probe.surface().tree();
        const base::Rayf ray = m_probe.rounded();
        DiscHit out;
        nearestDiscs(tree, {&ray, 1}, {static_cast<float>(from), m_options.tMax, tree.maxSupport()}, {&out, 1});
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
        if (m_known || isFar(m_probe.surface(), base::cast<float>(m_probe.position(from))))
            return std::nullopt;
        const Evaluation<T> at = m_probe.guess(from).at;
        if (at.status == Status::Outside)
            return std::nullopt;
        const double unit = at.unit > T(0) ? double(at.unit) : double(m_probe.surface().tree().maxSupport());
        const double end = std::min(from + reach * unit, double(m_options.tMax));
        const auto hit = m_march.first(from, end, unit, leaving);
        from = end;
        return hit;
    }

    IntersectOptions m_options;
    RayProbe<T> m_probe;
    const DiscHit* m_known;
    bool m_discs;
    RayMarch<T> m_march;
};

} // namespace surface
