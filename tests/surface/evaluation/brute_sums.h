// The sums of the brute force in float64 (brute_force.h): a loop over all surfels, with weights and their derivatives
// from the formulas of surface/README 2.1, none of them shared with the program.
#pragma once

#include "core/surface/surface.h"

#include <vector>

namespace brute {

using base::Mat3d, base::Vec3d;
using surface::Frame, surface::Weight;

struct Model {
    std::vector<surfel::Surfel> surfels;
    surface::SurfaceDefinition definition;
    bool normals = true, oriented = true;
    double scale = 1; ///< of all supports
};

inline Model modelOf(const surfel::SurfelList& list, const surface::SurfaceDefinition& definition) {
    return {list.items, definition, list.layout->normals, list.layout->normals && list.layout->oriented, 1};
}

/// The part of the model within `radius` of x: all that a position near x can see, at less cost.
inline Model near(const Model& model, const Vec3d& x, double radius) {
    Model out = model;
    out.surfels.clear();
    for (const surfel::Surfel& each : model.surfels)
        if (distance(base::cast<double>(each.position), x) <= radius)
            out.surfels.push_back(each);
    return out;
}

/// A weight by the distance in units of its scale, with its derivatives.
struct Phi {
    double v = 0, d = 0, dd = 0;
};

inline Phi phi(Weight weight, double r) {
    const double t = 1 - r;
    switch (weight) {
    case Weight::Wendland:
        return {std::pow(t, 4) * (4 * r + 1), -20 * r * std::pow(t, 3), -20 * std::pow(t, 3) + 60 * r * t * t};
    case Weight::WendlandC4:
        return {std::pow(t, 6) * (35 * r * r + 18 * r + 3) / 3, -56.0 / 3 * r * std::pow(t, 5) * (5 * r + 1),
                -56.0 / 3 * (std::pow(t, 5) * (10 * r + 1) - 5 * r * std::pow(t, 4) * (5 * r + 1))};
    case Weight::Gaussian:
        break;
    }
    const double v = std::exp(-r * r);
    return {v, -2 * r * v, (4 * r * r - 2) * v};
}

/// phi over the square of r / reach.
inline Phi interpolating(const Phi& p, double r, double reach) {
    const double k = reach * reach;
    return {k * p.v / (r * r), k * (p.d / (r * r) - 2 * p.v / (r * r * r)),
            k * (p.dd / (r * r) - 4 * p.d / (r * r * r) + 6 * p.v / (r * r * r * r))};
}

/// Which surfels count and how: all; those not facing away from the reference; all, flipped to its side; all, by
/// exp(-|n - reference|^2 / sigma^2).
enum class Mode { All, Skip, Flip, Refit };

/// Weighted sums that all frames share, with first derivatives.
struct Sums {
    int count = 0, flipped = 0;
    double w = 0, unit = 0;
    Vec3d wk, p;       ///< sum theta_k, sum theta (p - x)
    Mat3d pk;          ///< sum (p - x)_a theta_k
    Mat3d wkl, pkl[3]; ///< sum theta_kl, sum (p - x)_a theta_kl
    Vec3d m;           ///< sum theta n
    Mat3d mk;
    double u = 0; ///< sum theta n.(x - p)
    Vec3d uk;
    double np = 0, pp = 0; ///< sum theta n.(p - x), sum theta |p - x|^2, and with theta_k
    Vec3d npk, ppk;
    Mat3d s; ///< hyperplanes: sum theta n n^T; covariance: sum theta (x-p)(x-p)^T, total derivatives
    Mat3d sk[3];
};

inline Sums sums(const Model& model, const Vec3d& x, Mode mode = Mode::All, const Vec3d& reference = {}) {
    Sums out;
    const Weight weight = model.definition.weight;
    const bool hyperplanes = model.definition.frame == Frame::Hyperplanes;
    const double reach = weight == Weight::Gaussian ? double(surface::gaussianReach) : 1;
    const double sigma = double(model.definition.rimlsSigma);
    for (const surfel::Surfel& each : model.surfels) {
        const Vec3d away = x - base::cast<double>(each.position);
        const double distance = length(away), h = model.scale * double(each.support);
        if (distance >= h)
            continue;
        Vec3d n = base::cast<double>(each.normal);
        if (mode == Mode::Skip && dot(n, reference) <= double(-0.17f))
            continue;
        if (mode == Mode::Flip && dot(n, reference) < 0)
            n = -n;
        const double scale = h / reach, r = distance / scale;
        const double factor = mode == Mode::Refit ? std::exp(-lengthSq(n - reference) / (sigma * sigma)) : 1;
        Phi radial = phi(weight, r);
        if (model.definition.interpolating)
            radial = interpolating(radial, r, reach);
        const double theta = factor * radial.v;
        if (theta <= 0)
            continue;
        const Vec3d direction = away / distance;
        const Vec3d slope = direction * (factor * radial.d / scale); // theta_,k
        const Mat3d along = base::outer(direction, direction);
        const Mat3d bend = along * (factor * radial.dd / (scale * scale)) +
                           (Mat3d::identity() - along) * (factor * radial.d / (scale * distance)); // theta_,kl
        ++out.count;
        out.flipped += mode == Mode::Flip && dot(base::cast<double>(each.normal), reference) < 0;
        out.w += theta;
        out.unit += theta * scale;
        out.wk += slope;
        out.p -= away * theta;
        out.pk += outer(-away, slope);
        out.wkl += bend;
        for (std::size_t a = 0; a < 3; ++a)
            out.pkl[a] += bend * -away[a];
        out.m += n * theta;
        out.mk += outer(n, slope);
        out.u += theta * dot(n, away);
        out.uk += slope * dot(n, away) + n * theta;
        out.np -= theta * dot(n, away);
        out.npk -= slope * dot(n, away);
        out.pp += theta * lengthSq(away);
        out.ppk += slope * lengthSq(away);
        const Vec3d& y = hyperplanes ? n : away;
        out.s += outer(y, y) * theta;
        for (int k = 0; k < 3; ++k) {
            out.sk[k] += outer(y, y) * slope[static_cast<std::size_t>(k)];
            if (!hyperplanes) {
                const Vec3d e{k == 0 ? 1.0 : 0, k == 1 ? 1.0 : 0, k == 2 ? 1.0 : 0};
                out.sk[k] += (outer(e, away) + outer(away, e)) * theta;
            }
        }
    }
    return out;
}

} // namespace brute
