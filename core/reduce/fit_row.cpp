#include "core/reduce/fit_row.h"

#include "core/surface/evaluation/smooth_step.h"

#include <algorithm>
#include <cmath>

namespace reduce {

using base::Vec3d;

namespace {

constexpr double mu = 0.5;
constexpr double leastAgreement = 0.2, flattest = 0.05;
/// Where another sheet weighs as much, and normals agree less than this, both are put together as solids, each summed
/// on its own (surface/README 2.7); in between the plain sum is as good.
constexpr double twoSheets = 0.87, partEdge = 0.3, leastAgainst = 0.02;
/// In supports: from here on a residual counts as its root, and from there on not at all: other sheets, crumbs.
constexpr double largeResidual = 0.1, strayResidual = 0.5;

FitSums sum(std::span<FitTerm> terms, const Vec3d& normal, bool parted) {
    FitSums out;
    out.parted = parted;
    for (FitTerm& t : terms) {
        const double h = t.reach * (parted ? partSupport : 1);
        const double r = std::sqrt(lengthSq(t.y) + t.along * t.along) / h;
        t.theta = t.slope = 0;
        if (r >= 1)
            continue;
        const double part =
            parted ? surface::SmoothStep<double>((dot(t.normal, normal) + partEdge) / (2 * partEdge)).v : 1;
        const double q = 1 - r, q3 = q * q * q;
        t.theta = part * q3 * q * (4 * r + 1);
        t.slope = part * -20 * q3 / (h * h);
        out.weight += t.theta;
        out.against += dot(t.normal, normal) < -partEdge ? t.theta : 0;
        out.offset += t.y * t.theta;
        out.normals += t.normal * t.theta;
    }
    return out;
}

/// theta by p and q, over its slope: half of the square of the large semi-axis times y^T (d metric) y.
std::array<double, 2> byShape(const FitTerm& t) {
    const FitSite& s = *t.site;
    const double p = s.p(), q = s.q(), k = s.stretch(), u = dot(t.y, s.along[0]), v = dot(t.y, s.along[1]);
    constexpr double round = 1e-4;
    const double one = k > round ? std::sinh(k) / k : 1, two = k > round ? (std::cosh(k) - one) / (k * k) : 1.0 / 3;
    const double square = u * u + v * v, bent = p * (u * u - v * v) + 2 * q * u * v;
    const double same = one * square + two * bent, scale = 0.5 * std::exp(k);
    const double height = dot(t.y, s.normal0), across = k > round ? std::exp(-k) / k * height * height : 0;
    return {scale * (p * (same - across) + one * (u * u - v * v)), scale * (q * (same - across) + one * 2 * u * v)};
}

/// A normal of the tilted frame and its derivative along one of its tangents.
Vec3d tilt(const FitTerm& t, const Vec3d& along) {
    return (along - t.normal * dot(t.normal, along)) * (t.sign / (t.length * t.site->support));
}

} // namespace

Vec3d FitSite::shape() const {
    const double k = stretch();
    if (k == 0)
        return {};
    const double angle = 0.5 * std::atan2(q(), p()), size = std::sqrt(std::exp(2 * k) - 1);
    return along[0] * (size * std::cos(angle)) + along[1] * (size * std::sin(angle));
}

void FitSite::setShape(const Vec3d& b, double reach) {
    const double u = dot(b, along[0]), v = dot(b, along[1]), aspect = std::sqrt(1 + u * u + v * v);
    const double k = std::log(aspect), angle = 2 * std::atan2(v, u);
    shape0[0] = k * std::cos(angle), shape0[1] = k * std::sin(angle);
    support = reach / std::sqrt(aspect);
}

FitSums sumTerms(const Vec3d& place, const Vec3d& normal, bool oriented, std::span<FitTerm> terms) {
    double support = 0;
    for (FitTerm& t : terms) {
        t.d->fill(0);
        const Vec3d tilted = t.site->tilted();
        t.length = base::length(tilted);
        t.y = place - t.site->position();
        t.sign = !oriented && dot(tilted, normal) < 0 ? -1 : 1;
        t.normal = tilted * (t.sign / t.length);
        t.reach = t.site->reach();
        t.b = t.site->shape();
        t.along = dot(t.b, t.y);
        support = std::max(support, t.site->support);
    }
    FitSums all = sum(terms, normal, false);
    if (oriented && all.agreement() < twoSheets && all.against > leastAgainst * all.weight)
        all = sum(terms, normal, true);
    all.support = support;
    return all;
}

FitRow fitRow(const Vec3d& place, const Vec3d& normal, bool oriented, std::span<FitTerm> terms) {
    const FitSums all = sumTerms(place, normal, oriented, terms);
    if (!(all.weight > 1e-6) || all.agreement() < leastAgreement)
        return {};
    const double w = all.weight, m = length(all.normals);
    const Vec3d n = all.normals / m, d = all.offset / w;
    const Vec3d v = (d - n * dot(n, d)) / m; // d (n.d) / d (sum theta n)
    double heights = 0;
    for (const FitTerm& t : terms)
        heights += t.theta * dot(t.normal, t.y);
    const double f = (1 - mu) * dot(n, d) + mu * heights / w;
    // By the weight of each; the gradient at the place.
    const auto byWeight = [&](const FitTerm& t) {
        return ((1 - mu) * dot(n, t.y) + mu * dot(t.normal, t.y) - f) / w + (1 - mu) * dot(v, t.normal);
    };
    Vec3d g;
    for (const FitTerm& t : terms)
        g += (n * (1 - mu) + t.normal * mu) * (t.theta / w) + t.way() * (byWeight(t) * t.slope);
    const double steep = length(g), residual = f / steep, size = std::abs(residual) / all.support;
    if (!(steep > flattest) || !(size < strayResidual) || dot(g, normal) < 0)
        return {};
    const double weight = (size > largeResidual ? std::sqrt(largeResidual / size) : 1) / steep;
    for (const FitTerm& t : terms) {
        if (t.theta == 0)
            continue;
        const Vec3d byPlace = (n * (1 - mu) + t.normal * mu) * (t.theta / w) + t.way() * (byWeight(t) * t.slope);
        const Vec3d byNormal = (t.y * (mu / w) + v * (1 - mu)) * t.theta;
        const double scale = byWeight(t) * t.slope / t.site->support;
        // theta by the logarithm of h: - slope (|y|^2 + (b.y)^2)
        const double bySize = -scale * (lengthSq(t.y) + t.along * t.along);
        const auto [byP, byQ] = byShape(t);
        *t.d = {static_cast<float>(-weight * dot(byPlace, t.site->normal0)),
                static_cast<float>(weight * dot(byNormal, tilt(t, t.site->along[0]))),
                static_cast<float>(weight * dot(byNormal, tilt(t, t.site->along[1]))),
                static_cast<float>(-weight * dot(byPlace, t.site->along[0])),
                static_cast<float>(-weight * dot(byPlace, t.site->along[1])),
                static_cast<float>(weight * bySize),
                static_cast<float>(weight * scale * byP),
                static_cast<float>(weight * scale * byQ)};
    }
    return {true, f * weight};
}

} // namespace reduce
