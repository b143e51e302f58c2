// From near a root of f along a ray to the root itself: by slopes from a good guess, by planes from a sample close to
// the surface, by false position between two signs. Internal to the room.
#pragma once

#include "core/surface/rays/ray_accept.h"

namespace surface {

/// Newton's method along the ray from the first guess: t -= f / (g.d). The step's own error, step^2 |d.H.d| / 2 |g.d|
/// with the derivative of n standing in for H, tells when no further evaluation is needed. False where the ray
/// grazes, the root is not near the guess or not surface, or it is no root that a ray meets from `side`, the sign of
/// n.d at the disc.
template <class T>
bool polished(RayProbe<T>& probe, double guess, double side, RayHit<T>& out) {
    constexpr double steep = 0.05;        // least |n.d|
    constexpr double high = 0.3, far = 1; // of h: how far across and along the ray the root may be
    constexpr double nearSheets = 0.95;   // agreement
    constexpr double leastBend = 0.1;     // times 1 / h: what the derivative of n may not tell
    double t = guess;
    for (int i = 0; i < 6; ++i) {
        const Evaluation<T>& at = probe.guess(t);
        if (!isSurface(at))
            return false;
        const base::Vec3d& d = probe.direction();
        const base::Vec3d g = base::cast<double>(at.gradient);
        const double unit = double(at.unit), slope = dot(g, d);
        if (std::abs(slope) < steep || slope * side < 0)
            return false;
        const double step = -double(at.value) / slope;
        const double moved = std::abs(t + step - guess);
        if (moved > far * unit || moved * std::abs(slope) > high * unit)
            return false;
        t += step;
        const base::Vec3d turn = base::cast<double>(at.normalGradient * base::cast<T>(d));
        const double bend = std::max(std::abs(dot(turn, d)), leastBend / unit);
        // f has steps where near sheets part
        const double still = probe.tolerance(at, t), most = double(at.agreement) < nearSheets ? still : far * unit;
        if (std::abs(step) <= most && step * step * bend <= std::abs(slope) * still) {
            if (!probe.inRange(t))
                return false;
            hitAt(probe, t, at, at.gradient + base::cast<T>(turn * step), out);
            return true;
        }
    }
    return false;
}

/// Plane iteration (surface/README 4.3) from a sample within the band where |f| bounds the distance, on a ray that does
/// not graze: exact in a few steps, and at the first root.
template <class T>
std::optional<RayRoot> planeIteration(RayProbe<T>& probe, const RaySample<T>& start, double end) {
    constexpr double band = 0.5, steep = 0.25; // of h; least |n.d|
    if (std::abs(start.f()) > band * double(start.at.unit))
        return std::nullopt;
    RaySample<T> s = start;
    double furthest = end;
    for (int i = 0; i < 12; ++i) {
        const double slope = s.slope(probe.direction());
        // the root that comes first is met from the side where the start lies
        if (std::abs(slope) < steep || slope * start.f() > 0)
            return std::nullopt;
        const double step = -s.f() / slope, t = s.t + step, still = probe.tolerance(s.at, s.t);
        if (i == 0)
            furthest = std::min(end, start.t + 1.5 * step) + still;
        if (t < start.t - still || t > furthest)
            return std::nullopt;
        if (std::abs(step) <= still)
            return RayRoot{t};
        s = probe.sampleBeside(s, t);
        if (!s.usable())
            return std::nullopt;
    }
    return std::nullopt;
}

/// What f jumps by between two samples on either side of a crack: where the second pass for near sheets begins, which
/// all frames but `normals` have (surface/README 2.7), f has small steps, and a surface that crosses zero there would
/// let rays through; of two solids f is continuous. Zero for true jumps, which are no roots: from one sheet to another
/// normals turn.
template <class T>
double crackBetween(const RayProbe<T>& probe, const RaySample<T>& a, const RaySample<T>& b) {
    constexpr double widest = 0.1, steady = 0.9; // of h; least cosine of the normals
    const double step = b.f() - a.f(), along = a.slope(probe.direction()), behind = b.slope(probe.direction());
    const bool alike = double(dot(a.at.normal, b.at.normal) * a.sign * b.sign) >= steady;
    return alike && along * step > 0 && behind * step > 0 && std::abs(step) <= widest * double(b.at.unit)
               ? std::abs(step)
               : 0;
}

/// Illinois' false position on the transported f, then bisection. Nothing where the frame fails inside. REQUIRES:
/// different signs.
template <class T>
std::optional<RayRoot> bracketed(RayProbe<T>& probe, RaySample<T> a, RaySample<T> b) {
    constexpr int falsePositions = 16, refinements = 70;
    double fa = a.f(), fb = b.f();
    int moved = 0; // the end that moved last: -1 a, 1 b
    for (int i = 0; i < refinements; ++i) {
        double t = a.t + (b.t - a.t) * fa / (fa - fb);
        if (!(t > a.t && t < b.t) || i >= falsePositions)
            t = 0.5 * (a.t + b.t);
        const RaySample<T> c = probe.sampleBeside(a, t);
        if (!c.usable())
            return std::nullopt;
        const double fc = c.f(), still = probe.tolerance(c.at, t);
        if (std::abs(fc) <= 0.1 * still)
            return RayRoot{t};
        if (b.t - a.t <= still)
            return RayRoot{t, crackBetween(probe, a, b)};
        if ((fc < 0) == (fa < 0)) {
            a = c, fa = fc;
            fb *= moved == -1 ? 0.5 : 1;
            moved = -1;
        } else {
            b = c, fb = fc;
            fa *= moved == 1 ? 0.5 : 1;
            moved = 1;
        }
    }
    return std::nullopt;
}

} // namespace surface
