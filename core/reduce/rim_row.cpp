#include "core/reduce/rim_row.h"

#include <algorithm>
#include <cmath>

namespace reduce {

using base::Vec3d;

namespace {

constexpr double leastOff = 0.02;   ///< o / h from which on it has a direction
constexpr double leastSlope = 0.15; ///< of o along the surface: less leads nowhere
/// In supports: from here on a residual counts as its root, and from there on not at all: a hole too small to keep.
constexpr double largeRim = 0.15, strayRim = 0.6;

/// What a site adds to h: of an ellipse the radius of the disc of its area.
double unitOf(const FitTerm& t) {
    return t.reach * std::exp(-0.5 * t.site->stretch());
}

/// What o / h is made of.
struct Off {
    Vec3d way;       ///< from the centroid to the place
    double size = 0; ///< o, as on whole supports
    double unit = 0; ///< h
    double part = 1; ///< o over the length of the way
};

Off offOf(const FitSums& all, std::span<const FitTerm> terms) {
    Off out;
    out.way = all.offset / all.weight;
    out.part = all.parted ? 1 / partSupport : 1;
    out.size = length(out.way) * out.part;
    for (const FitTerm& t : terms)
        out.unit += t.theta * unitOf(t) / all.weight;
    return out;
}

constexpr double leastWeight = 1e-6;

} // namespace

std::optional<double> offCentreAt(const Vec3d& place, const Vec3d& normal, bool oriented, std::span<FitTerm> terms) {
    const FitSums all = sumTerms(place, normal, oriented, terms);
    if (!(all.weight > leastWeight))
        return std::nullopt;
    const Off off = offOf(all, terms);
    return off.size / off.unit;
}

FitRow rimRow(const Vec3d& place, const Vec3d& normal, bool oriented, double limit, std::span<FitTerm> terms) {
    const FitSums all = sumTerms(place, normal, oriented, terms);
    if (!(all.weight > leastWeight))
        return {};
    const Off off = offOf(all, terms);
    if (!(off.size > leastOff * off.unit))
        return {};
    const double w = all.weight;
    const Vec3d e = off.way * (off.part / length(off.way));
    const auto byWeight = [&](const FitTerm& t) {
        return (dot(e, t.y - off.way) - limit * (unitOf(t) - off.unit)) / w;
    };
    Vec3d slope = e;
    for (const FitTerm& t : terms)
        slope += t.way() * (byWeight(t) * t.slope);
    const double steep = length(slope - normal * dot(slope, normal));
    const double residual = (off.size - limit * off.unit) / steep, size = std::abs(residual) / all.support;
    if (!(steep > leastSlope) || !(size < strayRim))
        return {};
    const double weight = (size > largeRim ? std::sqrt(largeRim / size) : 1) / steep;
    for (const FitTerm& t : terms) {
        if (t.theta == 0)
            continue;
        const double scale = byWeight(t) * t.slope;
        const Vec3d byPlace = e * (t.theta / w) + t.way() * scale;
        // theta by the logarithm of h: - slope (|y|^2 + (b.y)^2); the mean of h by its own
        const double bySize =
            -(scale * (lengthSq(t.y) + t.along * t.along) + limit * t.theta * unitOf(t) / w) / t.site->support;
        t.d->at(3) = static_cast<float>(-weight * dot(byPlace, t.site->along[0]));
        t.d->at(4) = static_cast<float>(-weight * dot(byPlace, t.site->along[1]));
        t.d->at(5) = static_cast<float>(weight * bySize);
    }
    return {true, (off.size - limit * off.unit) * weight};
}

} // namespace reduce
