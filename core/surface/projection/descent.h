// A closest point where Newton's steps go round in circles: down the zero set of f, always nearer to x0. Internal to
// the room; one thread, one position.
//
//     y   <- on the zero set, from x0 along the gradient
//     t   =  the part of x0 - y along the surface there
//     y   <- on the zero set from y + a t, if that is nearer to x0 by a part of a |t|^2; else a is halved
//
// Between two sheets of few surfels, at tips and edges narrower than their supports, f bends within a tenth of a
// spacing: the plain image of one iterate lies where the other sheet decides, and its image back again, and halving
// steps that are no way down does not end that (surface/README 3.3). Here each step has to be one. The zero set is met
// by bracketing along a line, since a slope says little there. What is found is near a foot, for Newton to end.
//
// It costs up to `mostEvaluations`, and is asked where all else has failed.
#pragma once

#include "core/surface/evaluation/source.h"

#include <algorithm>
#include <optional>

namespace surface {

template <class T>
class Descent {
  public:
    /// `tolerance`: of places, in units of h.
    Descent(Source& source, const base::Vec3<T>& x0, const OrientationHint& hint, T tolerance)
        : m_source(source), m_x0(x0), m_hint(hint), m_tolerance(tolerance) {}

    /// On the zero set, from y; false where no way along the gradient leads there.
    bool start(const base::Vec3<T>& y) { return meet(y, T(farthest)); }
    /// One step. False: there is none that leads nearer, or so many evaluations are used.
    bool step() {
        const base::Vec3<T> away = m_x0 - m_y, along = away - m_up * dot(m_up, away);
        const T square = lengthSq(along), reach = T(longest) * m_unit;
        if (!(square > m_tolerance * m_tolerance * m_unit * m_unit))
            return false;
        const base::Vec3<T> from = m_y, up = m_up;
        const T before = lengthSq(away), most = std::min(T(1), reach / std::sqrt(square));
        for (m_part = std::min(T(2) * m_part, most); m_part > T(leastPart) * most; m_part *= T(0.5)) {
            if (m_evaluations > mostEvaluations)
                break;
            if (meet(from + along * m_part, T(longest)) && lengthSq(m_x0 - m_y) < before - T(enough) * m_part * square)
                return true;
        }
        m_y = from, m_up = up;
        return false;
    }
    const base::Vec3<T>& place() const { return m_y; }
    int evaluations() const { return m_evaluations; }

  private:
    static constexpr int mostEvaluations = 600;
    static constexpr double longest = 0.25;    ///< of a step, and how far from it the zero set is looked for, in h
    static constexpr double farthest = 1.5;    ///< from x0, in h: past places where f nearly vanishes
    static constexpr double leastPart = 1e-5;  ///< of a step
    static constexpr double enough = 0.1;      ///< part of the gain that a plane would give, which is 2 a |t|^2
    static constexpr double growth = 1.6;      ///< of the ways in which a change of sign is looked for
    static constexpr double firstWay = 1.0625; ///< of what the slope says: usually a little beyond the zero

    Evaluation<T> at(const base::Vec3<T>& y, Need need) {
        ++m_evaluations;
        return m_source.evaluate(y, need, m_hint);
    }
    static bool usable(const Evaluation<T>& e) { return e.ok() || e.status == Status::BeyondBoundary; }

    /// The zero of f on the line through y along its gradient.
    bool meet(const base::Vec3<T>& y, T reach) {
        const Evaluation<T> here = at(y, Need::Gradient);
        if (!usable(here))
            return false;
        const bool flat = !(lengthSq(here.gradient) > T(1e-4));
        const base::Vec3<T> line = flat ? here.normal : base::normalized(here.gradient);
        const T sign = here.value > T(0) ? T(-1) : T(1), slope = flat ? T(1) : length(here.gradient);
        const T least = m_tolerance * here.unit;
        T near = 0, nearValue = here.value, far = std::max(T(firstWay) * std::abs(here.value) / slope, least);
        T farValue = nearValue;
        if (std::abs(here.value) <= least)
            return take(y, here);
        for (;; near = far, nearValue = farValue, far *= T(growth)) {
            if (far > reach * here.unit)
                return false;
            const Evaluation<T> e = at(y + line * (sign * far), Need::Value);
            if (!usable(e))
                return false;
            farValue = e.value;
            if (!(farValue * here.value > T(0)))
                break;
        }
        return bisect(y, line * sign, near, nearValue, far, farValue, least);
    }

    /// Regula falsi (Illinois) between two signs.
    bool bisect(const base::Vec3<T>& y, const base::Vec3<T>& line, T a, T fa, T b, T fb, T least) {
        for (int round = 0; round < 60 && fb != T(0) && std::abs(b - a) > least; ++round) {
            const T c = b - fb * (b - a) / (fb - fa);
            const Evaluation<T> e = at(y + line * c, Need::Value);
            if (!usable(e))
                return false;
            if (e.value * fb < T(0))
                a = b, fa = fb;
            else
                fa *= T(0.5);
            b = c, fb = e.value;
            if (std::abs(fb) <= least)
                break;
        }
        const base::Vec3<T> place = y + line * b;
        const Evaluation<T> there = at(place, Need::Gradient);
        return usable(there) && std::abs(there.value) <= T(100) * least && take(place, there);
    }

    bool take(const base::Vec3<T>& y, const Evaluation<T>& e) {
        m_y = y;
        m_up = lengthSq(e.gradient) > T(1e-4) ? base::normalized(e.gradient) : e.normal;
        m_unit = e.unit;
        return true;
    }

    Source& m_source;
    base::Vec3<T> m_x0, m_y, m_up;
    OrientationHint m_hint;
    T m_tolerance, m_unit = 0, m_part = 1;
    int m_evaluations = 0;
};

} // namespace surface
