// Near sheets as two solids (surface/README 2.7): where normals disagree, the surfels are parted by the axis along
// which their normals vary most, and the heights of both parts put together as those of two solids: the larger one
// between walls that face away from each other, the smaller one between walls that face each other. Both walls keep
// their places, however near, and neither goes on where the other has cut it off.
//
// Everything is a smooth function of x, and jets carry it all: f has neither steps nor corners, g and the Hessian are
// exact.
//
//     all sums with products of normals  (assemble.h)
//       -> the axis e                    split
//       -> sums of both parts            sumParts; what is no pair of sheets gets no share
//       -> share of A among A and B      mixture
//       -> f, n, c                       mix
#pragma once

#include "core/surface/evaluation/neighbourhood.h"
#include "core/surface/evaluation/smooth_step.h"
#include "core/surface/evaluation/solid_sheet.h"
#include "core/surface/frames/height_field.h"

namespace surface {

/// Where something sets in, and where it is all there.
struct Ramp {
    double from, to;

    template <class T, int O>
    Jet<T, O> of(const Jet<T, O>& a) const {
        return stepBetween(a, from, to);
    }
    constexpr Ramp squared() const { return {from * from, to * to}; }
};

namespace two_solids {

constexpr double supports = 0.75;          ///< those of the parts' sums, to see no third sheet
constexpr Ramp reach{0.01, 0.05};          ///< weight of the parts over that of all
constexpr Ramp alongAxis{0.6, 0.8};        ///< of the variance of normals
constexpr Ramp weights{0.002, 0.02};       ///< of the lighter part
constexpr Ramp agreement{0.2, 0.4};        ///< |m|/w of each part
constexpr Ramp opposite{0.3, 0.7};         ///< -n_A.n_B
constexpr Ramp plane{0.05, 0.25};          ///< |m|/w of all, of the plane's share in the height over all
constexpr Ramp hinted{-0.6, 0.6};          ///< hint.(n_A - n_B)
constexpr double farther = 2;              ///< ways from x to the centroids, to where K is taken
constexpr Ramp side{0.03, 0.2};            ///< K, in spacings
constexpr Ramp several{0.15, 0.6};         ///< variances of heights, in spacings squared: another sheet among them
constexpr double trust = 0.2;              ///< variance that halves a part's weight
constexpr double rounded = 0.05;           ///< edges of the larger or smaller height, in spacings
constexpr double spreadOfSpacing = 1.7014; ///< mean squared distance in a plane, s^2: 5/36 of 3.5^2

} // namespace two_solids

template <class T, int O>
class TwoSolids {
  public:
    /// REQUIRES: `at` holds sums over all surfels with products of normals, and their centroid.
    explicit TwoSolids(Neighbourhood<T, O>& at) : m_at(at) {}

    /// f and n; centroid and agreement of the neighbourhood become those of what was put together.
    Field<T, O> run() {
        const T plain = static_cast<T>(1 - m_at.definition().mu());
        m_all = SolidSheet<T, O>(m_at.moments);
        m_all.mixPlane(two_solids::plane.squared().of(m_all.agreementSq) * plain);
        m_share = one() - Ramp{twoSheetsBelow, oneSheetBelow}.squared().of(m_all.agreementSq);
        const Jet<T, O> parted = m_share;
        Field<T, O> out{m_all.height, m_all.n, Cause::None};
        JetVec<T, O> axis;
        const bool found = m_share.v > T(0) && split(axis) && sumParts(axis, plain);
        if (!found || m_share.v < T(1))
            keepSide(parted);
        if (found)
            mix(out);
        if (!(lengthSq(valueOf(out.n)) > T(0)))
            out.cause = Cause::CancellingNormals;
        return out;
    }

  private:
    static Jet<T, O> one() { return constantJet<T, O>(1); }
    /// a + share (b - a)
    static Jet<T, O> between(const Jet<T, O>& a, const Jet<T, O>& b, const Jet<T, O>& share) {
        return a + share * (b - a);
    }

    /// Where all surfels count in f, on edges and rods: centroid and agreement are of those that face as n does, else
    /// rods would seem to have a boundary.
    void keepSide(const Jet<T, O>& parted) {
        if (!(parted.v > T(0)) || !(lengthSq(valueOf(m_all.n)) > T(0)))
            return;
        const Axis axis = axisOf(m_all.n);
        Moments<T, O> side;
        sumPart(axis, 1, Outer::None, side);
        if (!(side.one.v > leastWeight<T>))
            return;
        const Jet<T, O> inverseWeight = inverse(side.one);
        for (std::size_t k = 0; k < 3; ++k)
            m_at.centroid[k] = between(m_all.c[k], side.q[k] * inverseWeight, parted);
        m_at.agreement += parted.v * (agreementOf(side) - m_at.agreement);
    }

    /// Is the largest eigenvalue clearly below the part of the trace from which on an axis counts? Where it is, limit I
    /// - S is positive definite, which its minors tell for a tenth of what eigenvectors cost: over noise, mostly.
    static bool varyInSeveral(const Jet<T, O>* s) {
        constexpr double clearly = 0.999;
        const T trace = s[sym(0, 0)].v + s[sym(1, 1)].v + s[sym(2, 2)].v;
        const T limit = T(clearly * two_solids::alongAxis.from) * trace;
        const T a = limit - s[sym(0, 0)].v, b = limit - s[sym(1, 1)].v, c = limit - s[sym(2, 2)].v;
        const T d = s[sym(0, 1)].v, e = s[sym(0, 2)].v, f = s[sym(1, 2)].v; // their signs cancel but in d e f
        const T minor = a * b - d * d;
        return a > T(0) && minor > T(0) && c * minor - (a * f * f + b * e * e + T(2) * d * e * f) > T(0);
    }

    /// The axis: largest eigenvector of the covariance of normals. False where they vary alike in several directions.
    bool split(JetVec<T, O>& axis) {
        const Moments<T, O>& m = m_at.moments;
        Jet<T, O> s[6], largest;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = a; b < 3; ++b) {
                const Jet<T, O>& nn = m.outer[sym(int(a), int(b))];
                s[sym(int(a), int(b))] = (nn - m.n[a] * m.n[b] * m_at.inverseWeight) * m_at.inverseWeight;
            }
        if (varyInSeveral(s))
            return false;
        const FrameNormal<T, O> found = eigenvector(s, Pick::Largest);
        if (!found.valid)
            return false;
        axis = found.n;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                largest += axis[a] * axis[b] * s[sym(int(a), int(b))];
        const Jet<T, O> trace = s[sym(0, 0)] + s[sym(1, 1)] + s[sym(2, 2)];
        m_share = m_share * two_solids::alongAxis.of(largest * inverse(trace));
        return m_share.v > T(0);
    }

    /// False where there are no two sheets that face opposite ways. Of one alone within reach of the parts' sums
    /// nothing is asked: what disagrees with it is farther away.
    bool sumParts(const JetVec<T, O>& e, T plain) {
        namespace limits = two_solids;
        const Axis axis = axisOf(e);
        Moments<T, O> a, b;
        sumPart(axis, limits::supports, Outer::Offsets, a);
        sumPart(-axis, limits::supports, Outer::Offsets, b);
        const Jet<T, O> both = a.one + b.one;
        if (!(both.v > T(limits::reach.from) * m_at.moments.one.v))
            return false;
        const Jet<T, O> inverseBoth = inverse(both);
        const Jet<T, O> ofA = limits::weights.of(a.one * inverseBoth), ofB = limits::weights.of(b.one * inverseBoth);
        m_share = m_share * limits::reach.of(both * m_at.inverseWeight);
        if (ofA.v > T(0))
            take(m_a, a, ofA, plain);
        if (ofB.v > T(0))
            take(m_b, b, ofB, plain);
        const Jet<T, O> pair = ofA * ofB;
        m_mixture = (ofA - ofB + one() - pair) * T(0.5);
        if (!(m_share.v > T(0)) || !(pair.v > T(0)))
            return m_share.v > T(0);
        const Jet<T, O> opposite = limits::opposite.of(-dot(m_a.n, m_b.n));
        m_share = m_share * between(one(), opposite, pair);
        Jet<T, O> mix = mixture(m_a.thicknessSq(a), m_b.thicknessSq(b));
        if (lengthSq(m_at.side) > 0)
            mix = between(mix, byHint(), opposite);
        m_mixture += pair * mix;
        return m_share.v > T(0);
    }
    /// One part, that is `there` or about to be out of reach.
    void take(SolidSheet<T, O>& sheet, const Moments<T, O>& m, const Jet<T, O>& there, T plain) {
        sheet = SolidSheet<T, O>(m);
        m_share = m_share * between(one(), two_solids::agreement.squared().of(sheet.agreementSq), there);
        sheet.mixPlane(constantJet<T, O>(plain));
    }

    static Axis axisOf(const JetVec<T, O>& e) {
        Axis out;
        for (std::size_t a = 0; a < 3; ++a) {
            out.at[a] = static_cast<double>(e[a].v);
            for (std::size_t k = 0; k < e[a].d.size(); ++k)
                out.slope[k][a] = static_cast<double>(e[a].d[k]);
            for (std::size_t k = 0; k < e[a].dd.size(); ++k)
                out.bend[k][a] = static_cast<double>(e[a].dd[k]);
        }
        return out;
    }

    void sumPart(const Axis& axis, double supports, Outer outer, Moments<T, O>& out) const {
        SumOptions options = m_at.options;
        options.outer = outer;
        options.facing = Facing::Part;
        options.axis = &axis;
        options.reference = axis.at;
        options.scale *= static_cast<float>(supports);
        sum(m_at.clusters, m_at.x, options, out);
    }

    /// A hint asks for the sheet that faces its way, whatever cuts that off.
    Jet<T, O> byHint() const {
        Jet<T, O> along;
        for (std::size_t k = 0; k < 3; ++k)
            along += (m_a.n[k] - m_b.n[k]) * static_cast<T>(m_at.side[k]);
        return two_solids::hinted.of(along);
    }

    /// Share of A: all of it where its height is the larger one and there is a solid between A and B, or the smaller
    /// one and there is a gap. By weight where others are among them, and, less decidedly, where they coincide.
    Jet<T, O> mixture(const Jet<T, O>& thickA, const Jet<T, O>& thickB) const {
        namespace limits = two_solids;
        const Jet<T, O> perLength = inverseSpacing(), perSquare = perLength * perLength;
        Jet<T, O> apart;
        for (std::size_t k = 0; k < 3; ++k)
            apart += (m_a.n[k] - m_b.n[k]) * (m_a.c[k] - m_b.c[k]);
        // from what K tells at the centroids and both heights at x, on to where the walls are farther from x
        apart = (apart * T(limits::farther) + (m_a.height + m_b.height) * T(2 * (limits::farther - 1))) * perLength;
        const Jet<T, O> offA = thickA * perSquare, offB = thickB * perSquare;
        const Jet<T, O> pair = one() - limits::several.of(offA + offB);
        const Jet<T, O> solid = pair * limits::side.of(apart), gap = pair * limits::side.of(-apart);

        const Jet<T, O> higher = (m_a.height - m_b.height) * perLength;
        const Jet<T, O> square = higher * higher + constantJet<T, O>(T(limits::rounded * limits::rounded));
        const Jet<T, O> a = trusted(m_a.weight, offA), b = trusted(m_b.weight, offB);
        const Jet<T, O> heavier = (a - b) * inverse(a + b);
        const Jet<T, O> coincident = pair - solid - gap;
        return ((solid - gap) * higher * inverseSqrt(square) + (one() - pair) * heavier +
                coincident * heavier * heavier * heavier + one()) *
               T(0.5);
    }
    Jet<T, O> trusted(const Jet<T, O>& weight, const Jet<T, O>& off) const {
        const Jet<T, O> part = weight * m_at.inverseWeight;
        return part * part * inverse(one() + off * static_cast<T>(1 / two_solids::trust));
    }
    /// 1 / s, by the spread of all surfels. By way of units of h, for the range of float.
    Jet<T, O> inverseSpacing() const {
        const T scale = m_at.moments.one.v / m_at.moments.unit;
        const JetVec<T, O> c = m_all.c * scale;
        const Jet<T, O> spread = m_at.moments.square * m_at.inverseWeight * (scale * scale) - dot(c, c);
        return inverseSqrt(spread * static_cast<T>(1 / two_solids::spreadOfSpacing)) * scale;
    }

    void mix(Field<T, O>& out) {
        const auto put = [&](const Jet<T, O>& all, const Jet<T, O>& a, const Jet<T, O>& b) {
            return between(all, between(b, a, m_mixture), m_share);
        };
        // off-centre values are judged in supports: as if the parts had been summed on whole ones
        constexpr auto whole = static_cast<T>(1 / two_solids::supports);
        const JetVec<T, O> cA = m_a.centroidOn(whole), cB = m_b.centroidOn(whole);
        JetVec<T, O> n;
        for (std::size_t k = 0; k < 3; ++k) {
            n[k] = put(m_all.n[k], m_a.n[k], m_b.n[k]);
            m_at.centroid[k] = put(m_at.centroid[k], cA[k], cB[k]);
        }
        out.f = put(m_all.height, m_a.height, m_b.height);
        // half-way between both there is no normal: it turns over
        constexpr double least = 1e-6;
        out.n = lengthSq(valueOf(n)) > T(least) ? normalisedSum(n).n : m_mixture.v > T(0.5) ? m_a.n : m_b.n;
        // between one way and the other f bends more than n tells: that counts as disagreement
        const T ofA = std::sqrt(m_a.agreementSq.v), ofB = std::sqrt(m_b.agreementSq.v), part = m_share.v * m_share.v;
        m_at.agreement += part * part * (ofB + m_mixture.v * (ofA - ofB) - m_at.agreement);
    }

    Neighbourhood<T, O>& m_at;
    SolidSheet<T, O> m_all, m_a, m_b;
    Jet<T, O> m_share;   ///< of A and B, against all surfels together
    Jet<T, O> m_mixture; ///< of A, against B
};

} // namespace surface
