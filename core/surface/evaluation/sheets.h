// Near sheets (RESAMPLING 4): where another sheet is near, the sums leave out the surfels that face away from this one.
//
// How much of those counts is a smooth function of |m|/w, m the sum of all normals: all of it while the normals agree,
// nothing where they nearly cancel. In between sums are mixed, so that f has no step where the second pass sets in: a
// step is where iterations go round in circles and rays lose their sign. As the factors of rimls do, the share counts
// as constant when f is differentiated: its own slope tells where sheets part, not where the surface goes.
#pragma once

#include "core/surface/evaluation/moments.h"

namespace surface {

/// |m|/w from which on everything counts, and up to which nothing that faces away does. RESAMPLING has one limit, 0.7;
/// but a wall tilted by 0.5 rad pulls the other by up to 0.06 spacings before. So every frame and weight stays in 0.02.
constexpr double oneSheetBelow = 0.92, twoSheetsBelow = 0.82;

/// The part of the surfels facing away that counts, by |m|/w over all: 0 to 1, without corners.
template <class T>
T shareOfFacingAway(T agreement) {
    const T t = (agreement - T(twoSheetsBelow)) / T(oneSheetBelow - twoSheetsBelow);
    return t <= T(0) ? T(0) : t >= T(1) ? T(1) : t * t * t * (T(10) + t * (T(6) * t - T(15)));
}

/// kept + share (all - kept).
template <class T, int O>
Jet<T, O> mixed(const Jet<T, O>& all, const Jet<T, O>& kept, std::type_identity_t<T> share) {
    return kept + (all - kept) * share;
}

template <class T, int O>
Moments<T, O> mixed(const Moments<T, O>& all, const Moments<T, O>& kept, std::type_identity_t<T> share) {
    if (!(share > T(0)))
        return kept;
    Moments<T, O> out;
    out.samples = all.samples;
    out.unit = kept.unit + share * (all.unit - kept.unit);
    out.unitSlope = kept.unitSlope + (all.unitSlope - kept.unitSlope) * share;
    out.one = mixed(all.one, kept.one, share);
    out.height = mixed(all.height, kept.height, share);
    out.square = mixed(all.square, kept.square, share);
    for (std::size_t k = 0; k < 3; ++k) {
        out.q[k] = mixed(all.q[k], kept.q[k], share);
        out.n[k] = mixed(all.n[k], kept.n[k], share);
    }
    for (std::size_t k = 0; k < 6; ++k)
        out.outer[k] = mixed(all.outer[k], kept.outer[k], share);
    return out;
}

} // namespace surface
