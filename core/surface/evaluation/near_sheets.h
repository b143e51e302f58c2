// Near sheets for the frames that are not put together of two solids (surface/README 2.7; two_solids.h): where another
// sheet is near, the sums leave out the surfels that face away from this one.
//
// How much of those counts is a smooth function of |m|/w, m the sum of all normals: all of it while the normals agree,
// nothing where they nearly cancel. In between sums are mixed, so that f has no step where the second pass sets in: a
// step is where iterations go round in circles and rays lose their sign. As the factors of rimls do, the share counts
// as constant when f is differentiated: its own slope tells where sheets part, not where the surface goes.
#pragma once

#include "core/surface/evaluation/clusters.h"
#include "core/surface/evaluation/moving_sums.h"
#include "core/surface/evaluation/smooth_step.h"
#include "core/surface/evaluation/sufficiency.h"

namespace surface {

/// |m|/w from which on everything counts, and up to which nothing that faces away does. A wall tilted by 0.5 rad pulls
/// the other by up to 0.06 spacings at 0.7; with these limits every frame and weight stays within 0.02.
constexpr double oneSheetBelow = 0.92, twoSheetsBelow = 0.82;

/// The part of the surfels facing away that counts, by |m|/w over all: 0 to 1, without corners.
template <class T>
T shareOfFacingAway(T agreement) {
    return SmoothStep<T>((agreement - T(twoSheetsBelow)) / T(oneSheetBelow - twoSheetsBelow)).v;
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

/// The sheet that the sums of one evaluation keep to. Without a near one it changes nothing.
template <class T>
struct KeptSheet {
    bool another = false; ///< is one near?
    base::Vec3d towards;  ///< where the sheet that is kept faces
    T share = 1;          ///< part of what faces away that counts

    /// Sums over this sheet, whatever else is asked for.
    template <int O>
    void sum(ClusterSpan clusters, const base::Vec3<T>& x, const SumOptions& options, Moments<T, O>& out) const {
        surface::sum(clusters, x, options, out);
        if (!another)
            return;
        Moments<T, O> kept;
        sumFacing(clusters, x, options, kept);
        out = mixed(out, kept, share);
    }
    /// Without any that face away.
    template <int O>
    void sumFacing(ClusterSpan clusters, const base::Vec3<T>& x, SumOptions options, Moments<T, O>& out) const {
        options.facing = Facing::Skip;
        options.reference = towards;
        surface::sum(clusters, x, options, out);
    }
};

/// Tells sheets apart by `m`, the sums of all surfels at x, and leaves in it those of the sheet that `side` chooses:
/// its unit normal, or zero for that of the nearest surfel.
template <class T, int O>
KeptSheet<T> keepOneSheet(ClusterSpan clusters, const base::Vec3<T>& x, const base::Vec3d& side,
                          const SumOptions& options, Moments<T, O>& m) {
    KeptSheet<T> out;
    const T agreement = agreementOf(m);
    if (agreement >= T(oneSheetBelow))
        return out;
    const auto scale = static_cast<double>(options.scale);
    out.towards = lengthSq(side) > 0 ? side : nearestNormal(clusters, base::cast<double>(x), scale, options.shape);
    Moments<T, O> kept;
    out.sumFacing(clusters, x, options, kept);
    if (!(kept.one.v > leastWeight<T>))
        return out;
    out.another = true;
    out.share = shareOfFacingAway(agreement);
    m = mixed(m, kept, out.share);
    return out;
}

} // namespace surface
