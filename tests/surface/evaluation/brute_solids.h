// Near sheets as two solids (surface/README 2.7) by brute force in float64: loops over all surfels, none of the
// program's evaluation code. Values alone: derivatives are theirs by differences.
#pragma once

#include "surface/evaluation/brute_sums.h"

#include <array>
#include <optional>

namespace brute {

/// The quintic step.
inline double step(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

/// Largest eigenvalue of a symmetric matrix and its vector, by Jacobi's rotations.
inline std::pair<double, Vec3d> largestEigenpair(Mat3d a) {
    Mat3d v = Mat3d::identity();
    for (int sweep = 0; sweep < 12; ++sweep)
        for (int p = 0; p < 3; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0)
                    continue;
                const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
                Mat3d turn = Mat3d::identity();
                turn[p][p] = turn[q][q] = std::cos(angle);
                turn[p][q] = std::sin(angle), turn[q][p] = -std::sin(angle);
                a = transposed(turn) * a * turn;
                v = v * turn;
            }
    int best = 0;
    for (int k = 1; k < 3; ++k)
        if (a[k][k] > a[best][best])
            best = k;
    return {a[best][best], {v[0][best], v[1][best], v[2][best]}};
}

/// What the surfels on one side of an axis tell, or all of them.
struct SolidSums {
    double w = 0, unit = 0, height = 0, square = 0;
    Vec3d m, p; ///< sum theta n, sum theta (p - x)
    Mat3d nn, pp;

    double agreement() const { return length(m) / w; }
    Vec3d normal() const { return base::normalized(m); }
    Vec3d centroid() const { return p / w; }
    /// As on whole supports.
    Vec3d wholeCentroid() const {
        const Vec3d c = centroid(), across = normal() * dot(normal(), c);
        return across + (c - across) / 0.75;
    }
    double f(double plain) const { return -plain * dot(normal(), centroid()) + (1 - plain) * height / w; }
    double thickness() const {
        const Vec3d n = normal();
        return dot(n, pp * n) / w - std::pow(dot(n, centroid()), 2);
    }
};

inline SolidSums solidSums(const Model& model, const Vec3d& x, double scale, const Vec3d& axis = {}) {
    SolidSums out;
    const Weight weight = model.definition.weight;
    const double reach = weight == Weight::Gaussian ? double(surface::gaussianReach) : 1;
    for (const surfel::Surfel& each : model.surfels) {
        const Vec3d q = base::cast<double>(each.position) - x, n = base::cast<double>(each.normal);
        const double h = scale * model.scale * double(each.support), r = length(q) / (h / reach);
        if (length(q) >= h)
            continue;
        Phi radial = phi(weight, r);
        if (model.definition.interpolating)
            radial = interpolating(radial, r, reach);
        const double theta = radial.v * (lengthSq(axis) > 0 ? step(dot(n, axis), -double(0.3f), double(0.3f)) : 1);
        out.w += theta;
        out.unit += theta * h / reach;
        out.height -= theta * dot(n, q);
        out.square += theta * lengthSq(q);
        out.m += n * theta;
        out.p += q * theta;
        out.nn += outer(n, n) * theta;
        out.pp += outer(q, q) * theta;
    }
    return out;
}

struct TwoSolids {
    bool there = false; ///< do sheets meet here?
    double f = 0, agreement = 1;
    Vec3d n, c; ///< c relative to x
};

/// REQUIRES: oriented normals, some weight.
inline TwoSolids twoSolids(const Model& model, const Vec3d& x, const Vec3d& hint) {
    const double plain = model.definition.shrinkFree ? 0.5 : 1;
    const SolidSums all = solidSums(model, x, 1);
    const double agreement = all.agreement();
    if (agreement >= 0.92)
        return {};
    const double fade = step(agreement * agreement, 0.05 * 0.05, 0.25 * 0.25);
    TwoSolids out{true, all.f(plain * fade), agreement, all.normal(), all.centroid()};
    const double parted = 1 - step(agreement * agreement, 0.82 * 0.82, 0.92 * 0.92);
    const SolidSums side = solidSums(model, x, 1, out.n);
    out.c = all.centroid() + (side.centroid() - all.centroid()) * parted;
    out.agreement = agreement + (side.agreement() - agreement) * parted;
    const auto [largest, axis] = largestEigenpair(all.nn * (1 / all.w) - outer(all.m, all.m) * (1 / (all.w * all.w)));
    const double variance = 1 - agreement * agreement; // of unit normals
    const SolidSums a = solidSums(model, x, double(0.75f), axis), b = solidSums(model, x, double(0.75f), -axis);
    const double both = a.w + b.w;
    double share = parted * step(largest / variance, 0.6, 0.8);
    const double thereA = both > 0 ? step(a.w / both, 0.002, 0.02) : 0,
                 thereB = both > 0 ? step(b.w / both, 0.002, 0.02) : 0;
    const double two = thereA * thereB;
    share *= step(both / all.w, 0.01, 0.05);
    share *= thereA > 0 ? 1 + thereA * (step(a.agreement() * a.agreement(), 0.04, 0.16) - 1) : 1;
    share *= thereB > 0 ? 1 + thereB * (step(b.agreement() * b.agreement(), 0.04, 0.16) - 1) : 1;
    share *= two > 0 ? 1 + two * (step(-dot(a.normal(), b.normal()), 0.3, 0.7) - 1) : 1;
    if (share <= 0)
        return out;
    const Vec3d turn = a.normal() - b.normal();
    double ofA = 0;
    if (two > 0) {
        const double s = std::sqrt((all.square / all.w - lengthSq(all.centroid())) / 1.7014);
        const double offA = a.thickness() / (s * s), offB = b.thickness() / (s * s);
        const double k = 2 * (dot(turn, a.centroid() - b.centroid()) + a.f(plain) + b.f(plain)) / s;
        const double pair = 1 - step(offA + offB, 0.15, 0.6);
        const double solid = pair * step(k, 0.03, 0.2), gap = pair * step(-k, 0.03, 0.2);
        const double higher = (a.f(plain) - b.f(plain)) / s;
        const double weightA = a.w * a.w / (1 + offA / 0.2), weightB = b.w * b.w / (1 + offB / 0.2);
        const double heavier = (weightA - weightB) / (weightA + weightB);
        ofA = 0.5 + 0.5 * ((solid - gap) * higher / std::sqrt(higher * higher + 0.05 * 0.05) + (1 - pair) * heavier +
                           (pair - solid - gap) * std::pow(heavier, 3));
    }
    if (two > 0 && lengthSq(hint) > 0)
        ofA += step(-dot(a.normal(), b.normal()), 0.3, 0.7) * (step(dot(turn, hint), -0.6, 0.6) - ofA);
    ofA = (two > 0 ? two * ofA : 0) + (thereA - thereB + 1 - two) / 2;
    const auto mix = [&](const auto& one, const auto& first, const auto& second) {
        return one + (second + (first - second) * ofA - one) * share;
    };
    const SolidSums &first = thereA > 0 ? a : b, &second = thereB > 0 ? b : a; // either alone stands for both
    out.f = mix(out.f, first.f(plain), second.f(plain));
    out.c = mix(out.c, first.wholeCentroid(), second.wholeCentroid());
    out.n = base::normalized(mix(out.n, first.normal(), second.normal()));
    share *= share;
    share *= share;
    out.agreement = mix(out.agreement, first.agreement(), second.agreement());
    return out;
}

} // namespace brute
