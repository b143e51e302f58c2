// The surface by brute force in float64: a loop over all surfels, written from the formulas of alg. 2, 3 and 7 without
// any of the program's own evaluation code, to compare the reference with.
//
// Derivatives are those of alg. 7 term by term; eigenvectors come from Rayleigh quotient iteration and their
// derivatives from the bordered system [S - l, n; n^T, 0] [n_k; *] = [(l_k - S_k) n; 0].
#pragma once

#include "core/surface/surface.h"

#include <array>
#include <vector>

namespace brute {

using base::Mat3d, base::Vec3d;
using surface::Frame, surface::Weight;

struct Answer {
    bool valid = false;
    int samples = 0;
    double f = 0, o = 0, unit = 0, agreement = 1;
    Vec3d c, n, g;
};

struct Model {
    std::vector<surfel::Surfel> surfels;
    surface::SurfaceDefinition definition;
    bool normals = true, oriented = true;
};

inline Model modelOf(const surfel::SurfelList& list, const surface::SurfaceDefinition& definition) {
    return {list.items, definition, list.layout->normals, list.layout->normals && list.layout->oriented};
}

/// Solves a 4x4 system by Gauss with full row pivoting.
inline std::array<double, 4> solve4(std::array<std::array<double, 5>, 4> a) {
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t r = k + 1; r < 4; ++r)
            if (std::abs(a[r][k]) > std::abs(a[pivot][k]))
                pivot = r;
        std::swap(a[k], a[pivot]);
        for (std::size_t r = 0; r < 4; ++r)
            if (r != k) {
                const double factor = a[r][k] / a[k][k];
                for (std::size_t c = k; c < 5; ++c)
                    a[r][c] -= factor * a[k][c];
            }
    }
    return {a[0][4] / a[0][0], a[1][4] / a[1][1], a[2][4] / a[2][2], a[3][4] / a[3][3]};
}

inline std::array<double, 4> bordered(const Mat3d& s, double l, const Vec3d& n, const Vec3d& right) {
    std::array<std::array<double, 5>, 4> a{};
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            a[r][c] = s.m[r][c] - (r == c ? l : 0);
        a[r][3] = a[3][r] = n[r];
        a[r][4] = right[r];
    }
    return solve4(a);
}

/// Smallest or largest eigenpair: the value by the trigonometric formula, then Rayleigh quotient iteration.
inline std::pair<double, Vec3d> eigenpair(const Mat3d& s, bool largest) {
    const double q = trace(s) / 3;
    Mat3d b = s - Mat3d::identity() * q;
    double p = 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            p += b[r][c] * b[r][c];
    p = std::sqrt(p / 6);
    b *= 1 / p;
    const double angle = std::acos(std::clamp(determinant(b) / 2, -1.0, 1.0)) / 3;
    double l = q + 2 * p * std::cos(angle + (largest ? 0 : 2 * 3.14159265358979323846 / 3));
    Vec3d rows[3], best;
    for (int r = 0; r < 3; ++r)
        rows[r] = Vec3d{s[r][0], s[r][1], s[r][2]} - (r == 0   ? Vec3d{l, 0, 0}
                                                      : r == 1 ? Vec3d{0, l, 0}
                                                               : Vec3d{0, 0, l});
    for (int r = 0; r < 3; ++r) {
        const Vec3d candidate = cross(rows[r], rows[(r + 1) % 3]);
        if (lengthSq(candidate) > lengthSq(best))
            best = candidate;
    }
    Vec3d n = base::normalized(best);
    for (int i = 0; i < 4; ++i) {
        l = dot(n, s * n);
        // Newton's step for S n = l n, |n| = 1
        const Vec3d residual = n * l - s * n;
        const auto step = bordered(s, l, n, residual);
        n = base::normalized(n + Vec3d{step[0], step[1], step[2]});
    }
    return {dot(n, s * n), n};
}

/// Weighted sums that all frames share, with first derivatives.
struct Sums {
    int count = 0;
    double w = 0, unit = 0;
    Vec3d wk, p; ///< sum theta_k, sum theta (p - x)
    Mat3d pk;    ///< sum (p - x)_a theta_k
    Vec3d m;     ///< sum theta n
    Mat3d mk;
    double u = 0; ///< sum theta n.(x - p)
    Vec3d uk;
    Mat3d s; ///< hyperplanes: sum theta n n^T; covariance: sum theta (x-p)(x-p)^T, total derivatives
    Mat3d sk[3];
};

/// `reference` and `mode`: 0 all, 1 skip those facing away, 2 flip them.
inline Sums sums(const Model& model, const Vec3d& x, bool hyperplanes, int mode, const Vec3d& reference) {
    Sums out;
    const bool gauss = model.definition.weight == Weight::Gaussian;
    for (const surfel::Surfel& each : model.surfels) {
        const Vec3d away = x - base::cast<double>(each.position);
        const double distance = length(away), h = each.support;
        if (distance >= h)
            continue;
        Vec3d n = base::cast<double>(each.normal);
        if (mode == 1 && dot(n, reference) <= double(-0.17f))
            continue;
        if (mode == 2 && dot(n, reference) < 0)
            n = -n;
        const double scale = gauss ? h / double(surface::gaussianReach) : h, r = distance / scale;
        const double theta = gauss ? std::exp(-r * r) : std::pow(1 - r, 4) * (4 * r + 1);
        const double alpha = gauss ? -2 * theta : -20 * std::pow(1 - r, 3);
        if (theta <= 0)
            continue;
        const Vec3d slope = away * (alpha / (scale * scale)); // theta_,k
        ++out.count;
        out.w += theta;
        out.unit += theta * scale;
        out.wk += slope;
        out.p -= away * theta;
        out.pk += outer(-away, slope);
        out.m += n * theta;
        out.mk += outer(n, slope);
        out.u += theta * dot(n, away);
        out.uk += slope * dot(n, away) + n * theta;
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

/// n and Dn (row a, column k) of an eigenvector frame.
inline void eigenFrame(const Sums& s, bool largest, Vec3d& n, Mat3d& dn) {
    const auto [l, v] = eigenpair(s.s, largest);
    n = v;
    for (int k = 0; k < 3; ++k) {
        const Vec3d right = n * dot(n, s.sk[k] * n) - s.sk[k] * n;
        const auto nk = bordered(s.s, l, n, right);
        for (std::size_t a = 0; a < 3; ++a)
            dn.m[a][k] = nk[a];
    }
}

inline Vec3d nearestNormal(const Model& model, const Vec3d& x) {
    double least = 1e300;
    Vec3d out;
    for (const surfel::Surfel& each : model.surfels) {
        const Vec3d away = x - base::cast<double>(each.position), n = base::cast<double>(each.normal);
        const double metric = lengthSq(away) + 3 * dot(n, away) * dot(n, away);
        if (length(away) < each.support && metric < least)
            least = metric, out = n;
    }
    return out;
}

inline Answer evaluate(const Model& model, const Vec3d& x, const Vec3d& hint = {}) {
    Answer out;
    const Frame frame = model.definition.frame;
    const bool hyperplanes = frame == Frame::Hyperplanes;
    Sums s = sums(model, x, hyperplanes, 0, {});
    if (s.w < 1e-12 || s.count < 3)
        return out;
    int mode = 0;
    Vec3d reference;
    if (model.oriented && model.definition.oneSheet && length(s.m) / s.w < 0.7) {
        mode = 1;
        reference = lengthSq(hint) > 0 ? base::normalized(hint) : nearestNormal(model, x);
        s = sums(model, x, hyperplanes, mode, reference);
    }
    const Vec3d e = s.p / s.w, d = -e; // c - x, x - c
    Mat3d j;                           // dc_a/dx_k = (1/w) sum (p - c)_a theta_k
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t k = 0; k < 3; ++k)
            j.m[a][k] = (s.pk.m[a][k] - e[a] * s.wk[k]) / s.w;
    out.c = x + e;
    out.o = length(e);
    out.unit = s.unit / s.w;
    out.samples = s.count;
    Mat3d dn;
    if (frame == Frame::Normals) {
        const double rho = length(s.m);
        out.n = s.m / rho;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d mk{s.mk.m[0][k], s.mk.m[1][k], s.mk.m[2][k]};
            const Vec3d nk = (mk - out.n * dot(out.n, mk)) / rho;
            for (std::size_t a = 0; a < 3; ++a)
                dn.m[a][k] = nk[a];
        }
    } else if (frame == Frame::CovarianceAtCentroid) {
        Mat3d there;
        eigenFrame(sums(model, out.c, false, mode, reference), false, out.n, there);
        dn = there * j;
    } else {
        eigenFrame(s, hyperplanes, out.n, dn);
    }
    const Vec3d side = model.oriented ? s.m : hint;
    if (dot(out.n, side) < 0)
        out.n = -out.n, dn *= -1;
    if (model.normals && !model.oriented) {
        const Sums aligned = sums(model, x, hyperplanes, 2, out.n);
        s.m = aligned.m, s.u = aligned.u, s.uk = aligned.uk;
    }
    if (model.normals)
        out.agreement = length(s.m) / s.w;
    const double mu = model.normals && model.definition.shrinkFree ? 0.5 : 0;
    out.f = (1 - mu) * dot(out.n, d) + mu * s.u / s.w;
    const Vec3d plain = out.n - transposed(j) * out.n + transposed(dn) * d;
    out.g = plain * (1 - mu) + (s.uk - s.wk * (s.u / s.w)) * (mu / s.w);
    out.valid = true;
    return out;
}

/// Orthogonal projection by the plain fixed-point iteration of alg. 3.1 with the plane of alg. 2.6.
inline bool projectOrthogonally(const Model& model, const Vec3d& x0, Vec3d& foot) {
    foot = x0;
    for (int i = 0; i < 400; ++i) {
        const Answer a = evaluate(model, foot);
        if (!a.valid)
            return false;
        const Vec3d next = x0 - a.g * ((a.f + dot(a.n, x0 - foot)) / dot(a.n, a.g));
        const double step = distance(next, foot);
        foot = next;
        if (step < 1e-13 * a.unit)
            return true;
    }
    return false;
}

} // namespace brute
