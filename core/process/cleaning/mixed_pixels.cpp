#include "core/process/cleaning/mixed_pixels.h"

#include "core/base/ranked.h"
#include "core/process/cleaning/eye_view.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/part_progress.h"

#include <numbers>

namespace process {

namespace {

using Sights = std::span<const Sight>;

constexpr std::size_t looked = 80;  ///< nine by nine places of a grid, without the middle one
constexpr std::size_t judging = 48; ///< seven by seven, of which a plane holds some
constexpr std::size_t leading = 12; ///< of which two and the point make a plane
constexpr std::size_t ringed = 8;

Sights firstOf(Sights sights, std::size_t count) {
    return sights.first(std::min(sights.size(), count));
}

bool opposite(const Sight& a, const Sight& b) {
    const double along = a.u * b.u + a.v * b.v;
    return along < 0 && along * along > 0.5 * (a.u * a.u + a.v * a.v) * (b.u * b.u + b.v * b.v);
}

/// How far a point stands over the middle of two opposite neighbours, as a part of its range.
double unevenness(Sights sights) {
    std::vector<double> over;
    const Sights ring = firstOf(sights, ringed);
    for (std::size_t j = 0; j < ring.size(); ++j)
        for (std::size_t k = j + 1; k < ring.size(); ++k)
            if (opposite(ring[j], ring[k]))
                over.push_back(std::abs(ring[j].w + ring[k].w - 2) / std::sqrt(6.0));
    return deviationOverMad * base::median(over);
}

/// Noise is what the quieter ones around have: where beams are wide, most of them may be uneven. Reorders.
double noiseOf(std::vector<double>& unevenness) {
    constexpr double middleOverFifth = 1.3;
    return middleOverFifth * base::ranked(unevenness, unevenness.size() / 5);
}

/// What lies along lines across the point.
class Profile {
  public:
    /// `flat`: less than this is no rise.
    Profile(Sights sights, double spacing, double flat) : m_sights(sights), m_spacing(spacing), m_flat(flat) {}

    /// The first one in a direction, a unit vector; null where there is none.
    const Sight* beside(double u, double v) const {
        const Sight* const out = near(u, v, 1);
        return out ? out : near(u, v, 2);
    }
    /// How many beams it is up to flat ground: where a step is below a third of the steepest before it. `side`: 1 for
    /// ground that is nearer, -1. 0 where there is no such ground within reach.
    int steps(double u, double v, double side) const {
        double steepest = 0, before = 1, distance = 0;
        int out = 0;
        for (int k = 1; k <= reach; ++k) {
            const Sight* at = near(u, v, k);
            if (!at)
                continue; // a beam that did not come back
            const double along = at->u * u + at->v * v, span = std::max(along - distance, 0.5 * m_spacing);
            const double rise = side * (at->w - before) * m_spacing / span;
            if (out > 0 && rise < std::max(steepest / 3, m_flat))
                return out;
            steepest = std::max(steepest, rise), before = at->w, distance = along, out = k;
        }
        return 0;
    }

  private:
    static constexpr int reach = 4;

    const Sight* near(double u, double v, int k) const {
        const Sight* out = nullptr;
        double least = 0.36 * m_spacing * m_spacing;
        for (const Sight& s : m_sights) {
            const double du = s.u - u * k * m_spacing, dv = s.v - v * k * m_spacing;
            if (const double d = du * du + dv * dv; d < least)
                least = d, out = &s;
        }
        return out;
    }

    Sights m_sights;
    double m_spacing, m_flat;
};

/// Whether most ways from what is nearer to what is farther go over a short bridge. `step`: what is a rise at all.
bool bridges(const Profile& profile, double step) {
    constexpr int longest = 4, directions = 16;
    int crossed = 0, bridged = 0;
    for (int k = 0; k < directions; ++k) {
        const double a = 2 * std::numbers::pi * k / directions, u = std::cos(a), v = std::sin(a);
        const Sight *const near = profile.beside(u, v), *const far = profile.beside(-u, -v);
        if (!near || !far || near->w < 1 + step || far->w > 1 - step)
            continue;
        ++crossed;
        const int up = profile.steps(u, v, 1), down = profile.steps(-u, -v, -1);
        bridged += up > 0 && down > 0 && up + down <= longest;
    }
    return crossed > 0 && 2 * bridged >= crossed;
}

/// The largest part of the sights that a plane through the point and two of them holds, up to noise and, where it is
/// steep, up to a part of its rise: rims of balls are no planes.
double held(Sights sights, double noise) {
    constexpr double bend = 0.3, deviations = 3;
    const Sights some = firstOf(sights, leading);
    std::size_t most = 0;
    for (std::size_t j = 0; j < some.size(); ++j)
        for (std::size_t k = j + 1; k < some.size(); ++k) {
            const Sight &a = some[j], &b = some[k];
            const double area = a.u * b.v - a.v * b.u;
            if (area * area < 0.1 * (a.u * a.u + a.v * a.v) * (b.u * b.u + b.v * b.v))
                continue; // nearly on a line
            const double p = ((a.w - 1) * b.v - (b.w - 1) * a.v) / area;
            const double q = ((b.w - 1) * a.u - (a.w - 1) * b.u) / area;
            std::size_t count = 0;
            for (const Sight& s : sights) {
                const double rise = p * s.u + q * s.v;
                count += std::abs(s.w - 1 - rise) < std::max(deviations * noise, bend * std::abs(rise));
            }
            most = std::max(most, count);
        }
    return static_cast<double>(most) / static_cast<double>(sights.size());
}

bool isMixed(Sights sights, double spacing, double noise, double limit) {
    constexpr double enough = 0.45, flat = 3, deviations = 5;
    const double step = std::max(deviations * noise, limit * spacing);
    return bridges({sights, spacing, flat * noise}, step) && held(firstOf(sights, judging), noise) < enough;
}

void judge(const EyeView& view, const MixedQuestion& question, std::vector<std::uint8_t>& found,
           const base::Progress& progress) {
    const Cloud& directions = view.directions();
    if (directions.size() <= looked)
        return; // too few to tell
    std::vector<float> uneven(directions.size());
    directions.forEach(ringed, part(progress, 0, 0.3), "Measuring noise", [&](std::size_t i, const Neighbours& near) {
        std::vector<Sight> sights;
        view.sights(view.seen(i)[0], near, sights);
        uneven[i] = static_cast<float>(unevenness(sights));
    });
    directions.forEach(looked, part(progress, 0.3, 1), "Looking for mixed pixels",
                       [&](std::size_t i, const Neighbours& near) {
                           constexpr std::size_t beside = 4;
                           std::vector<Sight> sights;
                           std::vector<double> around;
                           for (const std::uint32_t j : near.index)
                               around.push_back(static_cast<double>(uneven[j]));
                           double spacing = 0;
                           for (std::size_t k = 0; k < beside; ++k)
                               spacing += std::sqrt(static_cast<double>(near.distanceSq[k])) / beside;
                           const double noise = noiseOf(around);
                           for (const std::uint32_t seen : view.seen(i)) {
                               view.sights(seen, near, sights);
                               found[view.numberOf(seen)] = isMixed(sights, spacing, noise, question.limit);
                           }
                       });
}

} // namespace

std::vector<std::uint8_t> findMixedPixels(const surfel::SurfelList& points, const Eyes& eyes,
                                          const MixedQuestion& question, const base::Progress& progress) {
    std::vector<std::uint8_t> found(points.size());
    std::vector<std::vector<std::uint32_t>> of(eyes.places.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        of[eyes.of.empty() ? 0 : eyes.of[i]].push_back(i);
    const auto share = [&](std::size_t e) { return static_cast<double>(e) / static_cast<double>(of.size()); };
    for (std::size_t e = 0; e < of.size(); ++e) {
        const base::Progress own = part(progress, share(e), share(e + 1));
        judge({points, std::move(of[e]), eyes.places[e], part(own, 0, 0.1)}, question, found, part(own, 0.1, 1));
    }
    return found;
}

} // namespace process
