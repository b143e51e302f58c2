// The surface by brute force in float64: a loop over all surfels, written from the formulas of surface/README 2, 3 and
// 6 without any of the program's own evaluation code, to compare the reference with.
//
// Derivatives are those of surface/README 6 term by term; eigenvectors come from Rayleigh quotient iteration and their
// derivatives from the bordered system [S - l, n; n^T, 0] [n_k; *] = [(l_k - S_k) n; 0].
#pragma once

#include "surface/evaluation/brute_solids.h"

#include <array>
#include <vector>

namespace brute {

/// What the last pass of rimls weighs by.
struct Pass {
    Mode mode = Mode::All;
    Vec3d reference;
};

struct Answer {
    bool valid = false;
    int samples = 0, samplesAtCentroid = 0, flipped = 0;
    double f = 0, o = 0, unit = 0, agreement = 1;
    Vec3d c, n, g;
    double share = -1;   ///< of what faces away, where there are two sheets
    bool solids = false; ///< put together of two; derivatives are differences then
    Vec3d hint;          ///< that it was asked with
    Pass pass;           ///< of rimls
    double sphere = 1;   ///< of apss: |q| h; its formulas as printed lose digits as that goes to zero
};

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

/// How much those facing away count, by |m|/w of all: a quintic step from 0 at 0.82 to 1 at 0.92.
inline double shareOf(const Sums& all) {
    const double t = std::clamp((length(all.m) / all.w - 0.82) / 0.1, 0.0, 1.0);
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

/// kept + share (all - kept), the share held still.
inline Sums mixed(const Sums& all, const Sums& kept, double share) {
    const auto mix = [share](const auto& a, const auto& k) { return k + (a - k) * share; };
    Sums out = kept;
    out.count = share > 0 ? all.count : kept.count;
    out.w = mix(all.w, kept.w), out.unit = mix(all.unit, kept.unit), out.u = mix(all.u, kept.u);
    out.np = mix(all.np, kept.np), out.pp = mix(all.pp, kept.pp);
    out.wk = mix(all.wk, kept.wk), out.uk = mix(all.uk, kept.uk);
    out.npk = mix(all.npk, kept.npk), out.ppk = mix(all.ppk, kept.ppk);
    out.p = mix(all.p, kept.p), out.m = mix(all.m, kept.m), out.pk = mix(all.pk, kept.pk);
    out.mk = mix(all.mk, kept.mk), out.wkl = mix(all.wkl, kept.wkl), out.s = mix(all.s, kept.s);
    for (std::size_t k = 0; k < 3; ++k) {
        out.pkl[k] = mix(all.pkl[k], kept.pkl[k]);
        out.sk[k] = mix(all.sk[k], kept.sk[k]);
    }
    return out;
}

/// dc_a/dx_k = (1/w) sum (p - c)_a theta_k.
inline Mat3d centroidGradient(const Sums& s) {
    const Vec3d e = s.p / s.w;
    Mat3d j;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t k = 0; k < 3; ++k)
            j.m[a][k] = (s.pk.m[a][k] - e[a] * s.wk[k]) / s.w;
    return j;
}

/// n and Dn (row a, column k) of an eigenvector of s with derivatives sk.
inline void eigenFrame(const Mat3d& s, const Mat3d (&sk)[3], bool largest, Vec3d& n, Mat3d& dn) {
    const auto [l, v] = eigenpair(s, largest);
    n = v;
    for (int k = 0; k < 3; ++k) {
        const Vec3d right = n * dot(n, sk[k] * n) - sk[k] * n;
        const auto nk = bordered(s, l, n, right);
        for (std::size_t a = 0; a < 3; ++a)
            dn.m[a][k] = nk[a];
    }
}

/// Eigenvector of J J^T; J_,k from c_a,kl = (1/w) (sum (p - c)_a theta_kl - J_ak w_l - J_al w_k).
inline void centroidGradientFrame(const Sums& s, Vec3d& n, Mat3d& dn) {
    const Mat3d j = centroidGradient(s);
    const Vec3d e = s.p / s.w;
    Mat3d sk[3];
    for (std::size_t k = 0; k < 3; ++k) {
        Mat3d jk;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t l = 0; l < 3; ++l)
                jk.m[a][l] =
                    (s.pkl[a].m[k][l] - e[a] * s.wkl.m[k][l] - j.m[a][k] * s.wk[l] - j.m[a][l] * s.wk[k]) / s.w;
        sk[k] = jk * transposed(j) + j * transposed(jk);
    }
    eigenFrame(j * transposed(j), sk, false, n, dn);
}

/// m / |m|.
inline void normalFrame(const Sums& s, Vec3d& n, Mat3d& dn) {
    const double rho = length(s.m);
    n = s.m / rho;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d mk{s.mk.m[0][k], s.mk.m[1][k], s.mk.m[2][k]};
        const Vec3d nk = (mk - n * dot(n, mk)) / rho;
        for (std::size_t a = 0; a < 3; ++a)
            dn.m[a][k] = nk[a];
    }
}

/// Centre b and radius r of the fitted sphere, as [Guennebaud07] print them, with derivatives. REQUIRES: not a plane.
inline void apss(const Model& model, const Sums& s, Answer& out) {
    const double beta = double(model.definition.apssBeta);
    const double above = s.np - dot(s.p, s.m) / s.w, below = s.pp - lengthSq(s.p) / s.w;
    const double q = 0.5 * beta * above / below;
    const Vec3d l = (s.m - s.p * (2 * q)) / s.w, b = l * (-0.5 / q);
    const double c0 = -(dot(l, s.p) + q * s.pp) / s.w, r = std::sqrt(lengthSq(b) - c0 / q), sign = q < 0 ? -1 : 1;
    out.f = sign * (length(b) - r);
    out.sphere = std::abs(q) * out.unit;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d pk{s.pk.m[0][k], s.pk.m[1][k], s.pk.m[2][k]}, mk{s.mk.m[0][k], s.mk.m[1][k], s.mk.m[2][k]};
        const double w = s.w, wk = s.wk[k];
        const double aboveK = s.npk[k] - (dot(pk, s.m) + dot(s.p, mk)) / w + dot(s.p, s.m) * wk / (w * w);
        const double belowK = s.ppk[k] - 2 * dot(s.p, pk) / w + lengthSq(s.p) * wk / (w * w);
        const double qk = 0.5 * beta * (aboveK / below - above * belowK / (below * below));
        const Vec3d lk = (mk - pk * (2 * q) - s.p * (2 * qk)) / w - l * (wk / w);
        const double c0k = -(dot(lk, s.p) + dot(l, pk) + qk * s.pp + q * s.ppk[k]) / w - c0 * wk / w;
        const Vec3d bk = lk * (-0.5 / q) + l * (0.5 * qk / (q * q));
        const double rk = (dot(b, bk) - 0.5 * (c0k / q - c0 * qk / (q * q))) / r;
        const Vec3d e{k == 0 ? 1.0 : 0, k == 1 ? 1.0 : 0, k == 2 ? 1.0 : 0};
        const double slope = sign * (-dot(b, e - bk) / length(b) - rk);
        out.g = k == 0 ? Vec3d{slope, 0, 0} : k == 1 ? Vec3d{out.g.x, slope, 0} : Vec3d{out.g.x, out.g.y, slope};
    }
    out.n = base::normalized(-b) * sign;
}

/// f, g and n of one pass (surface/README 2.9): g the derivative with the factors held still.
inline void rimlsPass(const Sums& s, Answer& out) {
    out.samples = s.count;
    out.f = s.u / s.w;
    out.g = (s.uk - s.wk * out.f) / s.w; // uk holds sum w_i n_i too
    out.n = base::normalized(s.m);
}

/// The passes as printed, the first over `first`; returns what the last weighs by.
inline Pass rimls(const Model& model, const Vec3d& x, const Sums& first, Answer& out) {
    Vec3d before;
    Pass pass;
    for (int i = 0; i < 3; ++i) {
        if (i > 0)
            pass = {Mode::Refit, before};
        rimlsPass(i > 0 ? sums(model, x, pass.mode, pass.reference) : first, out);
        if (lengthSq(out.g - before) <= 1e-3)
            break;
        before = out.g;
    }
    return pass;
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

/// Derivative along axis k by differences of sixth order.
template <class Fn>
auto difference(const Fn& fn, const Vec3d& x, int k, double step) {
    const Vec3d by{k == 0 ? step : 0, k == 1 ? step : 0, k == 2 ? step : 0};
    const auto pair = [&](int i) { return fn(x + by * i) - fn(x - by * i); };
    return (pair(1) * 45 - pair(2) * 9 + pair(3)) * (1 / (60 * step));
}

/// Where near sheets meet, for summed normals. False where they do not.
inline bool solidsAt(const Model& model, const Vec3d& x, const Sums& s, const Vec3d& hint, Answer& out) {
    const Vec3d side = base::normalized(hint);
    const TwoSolids at = twoSolids(model, x, side);
    if (!at.there)
        return false;
    out.valid = out.solids = true;
    out.hint = side;
    out.samples = s.count;
    out.unit = s.unit / s.w;
    out.f = at.f, out.n = at.n, out.c = x + at.c, out.o = length(at.c), out.agreement = at.agreement;
    for (int k = 0; k < 3; ++k)
        out.g[static_cast<std::size_t>(k)] =
            difference([&](const Vec3d& y) { return twoSolids(model, y, side).f; }, x, k, 1e-4 * out.unit);
    return true;
}

/// A share >= 0 is that of another position, held still.
inline Answer evaluate(const Model& model, const Vec3d& x, const Vec3d& hint = {}, double atShare = -1) {
    Answer out;
    const Frame frame = model.definition.frame;
    Sums s = sums(model, x);
    if (s.w < 1e-12 || s.count < 3)
        return out;
    const bool solids = frame == Frame::Normals && model.oriented && model.definition.oneSheet;
    if (solids && solidsAt(model, x, s, hint, out))
        return out;
    Vec3d reference;
    double share = 1;
    const bool two = !solids && model.oriented && model.definition.oneSheet && length(s.m) / s.w < 0.92;
    if (two) {
        reference = lengthSq(hint) > 0 ? base::normalized(hint) : nearestNormal(model, x);
        share = atShare >= 0 ? atShare : shareOf(s);
        s = mixed(s, sums(model, x, Mode::Skip, reference), share);
    }
    const Vec3d e = s.p / s.w, d = -e; // c - x, x - c
    const Mat3d j = centroidGradient(s);
    out.valid = true;
    out.c = x + e;
    out.o = length(e);
    out.unit = s.unit / s.w;
    out.samples = s.count;
    out.share = two ? share : -1;
    out.agreement = model.normals ? length(s.m) / s.w : 1;
    if (frame == Frame::Apss) {
        apss(model, s, out);
        return out;
    }
    if (frame == Frame::Rimls) {
        out.pass = rimls(model, x, s, out);
        return out;
    }
    Mat3d dn;
    if (frame == Frame::Normals) {
        normalFrame(s, out.n, dn);
    } else if (frame == Frame::CovarianceAtCentroid) {
        Sums there = sums(model, out.c);
        out.samplesAtCentroid = there.count;
        if (two)
            there = mixed(there, sums(model, out.c, Mode::Skip, reference), share);
        Mat3d dnThere;
        eigenFrame(there.s, there.sk, false, out.n, dnThere);
        dn = dnThere * j;
    } else if (frame == Frame::CentroidGradient) {
        centroidGradientFrame(s, out.n, dn);
    } else {
        eigenFrame(s.s, s.sk, frame == Frame::Hyperplanes, out.n, dn);
    }
    const Vec3d side = model.oriented ? s.m : hint;
    if (dot(out.n, side) < 0)
        out.n = -out.n, dn *= -1;
    if (model.normals && !model.oriented) {
        const Sums aligned = sums(model, x, Mode::Flip, out.n);
        s.m = aligned.m, s.u = aligned.u, s.uk = aligned.uk;
        out.agreement = length(s.m) / s.w;
        out.flipped = aligned.flipped;
    }
    const double mu = model.normals && model.definition.shrinkFree ? 0.5 : 0;
    out.f = (1 - mu) * dot(out.n, d) + mu * s.u / s.w;
    const Vec3d plain = out.n - transposed(j) * out.n + transposed(dn) * d;
    out.g = plain * (1 - mu) + (s.uk - s.wk * (s.u / s.w)) * (mu / s.w);
    return out;
}

/// The same branch of f beside a position where it was answered: signs, sheets and the factors of rimls stay.
inline Answer beside(const Model& model, const Answer& at, const Vec3d& y) {
    if (model.definition.frame != Frame::Rimls)
        return evaluate(model, y, at.solids ? at.hint : at.n, at.share);
    Answer out;
    rimlsPass(sums(model, y, at.pass.mode, at.pass.reference), out);
    return out;
}

/// Does the set of samples change within the reach of `difference`, where that is a step: at the Gaussian's cut, and
/// where a normal across n is turned to the other side?
inline bool stepsNear(const Model& model, const Answer& at, const Vec3d& x, double step) {
    const bool cut = model.definition.weight == Weight::Gaussian;
    for (std::size_t k = 0; k < 3 && (cut || (model.normals && !model.oriented)); ++k)
        for (int i : {-3, -2, -1, 1, 2, 3}) {
            Vec3d y = x;
            (k == 0 ? y.x : k == 1 ? y.y : y.z) += i * step;
            const Answer there = beside(model, at, y);
            const bool other = there.samples != at.samples || there.samplesAtCentroid != at.samplesAtCentroid;
            if (there.flipped != at.flipped || (cut && other))
                return true;
        }
    return false;
}

/// The Hessian by differences of the gradient.
inline Mat3d hessian(const Model& model, const Vec3d& x, const Answer& at, double step) {
    Mat3d out;
    for (int k = 0; k < 3; ++k) {
        const Vec3d column = difference([&](const Vec3d& y) { return beside(model, at, y).g; }, x, k, step);
        for (std::size_t a = 0; a < 3; ++a)
            out.m[a][k] = column[a];
    }
    return (out + transposed(out)) * 0.5;
}

} // namespace brute
