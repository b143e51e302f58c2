// First stage of an evaluation: weighted sums over the surfels in support of a position (surface/README 2.1, 2.2).
//
// With q_i = p_i - x and theta_i(x), each sum is a jet in x whose derivatives act on the weights alone, the monomials
// staying as they are at x: sum theta y, sum theta_,k y, sum theta_,kl y. That q_i moves with x too is accounted for by
// `timesCoordinate` in the second stage (assemble.h).
//
// Two implementations: float32, vectorised (moments_float.cpp), and float64 with the bits of plain loops
// (moments_double.cpp).
#pragma once

#include "core/surface/evaluation/jet.h"
#include "core/surface/frames/frame_table.h"

#include <span>

namespace surface {

/// What happens to surfels by their normal's angle to a reference: nothing; those facing away are skipped (the second
/// pass of surface/README 2.7); normals are flipped to the reference's side (unoriented normals); weights are
/// multiplied by exp(-|n - reference|^2 / sigma^2), the factor counting as constant (the refits of rimls,
/// surface/README 2.9); weights are multiplied by a smooth step of the normal's part along a moving axis (the two
/// solids of surface/README 2.7).
enum class Facing { All, Skip, Flip, Refit, Part };
constexpr float facingLimit = -0.17f;
constexpr float leastInterpolation = 1e-12f;

/// A unit vector that moves with x.
struct Axis {
    base::Vec3d at, slope[3], bend[6]; ///< and its derivatives by x; the second by `sym`

    Axis operator-() const {
        Axis out = *this;
        out.at = -at;
        for (base::Vec3d& each : out.slope)
            each = -each;
        for (base::Vec3d& each : out.bend)
            each = -each;
        return out;
    }
};

/// Part along the axis above minus which a normal begins to count, and above which it counts wholly.
constexpr float partingLimit = 0.3f;

struct SumOptions {
    Weight weight = Weight::Wendland;
    Outer outer = Outer::None;
    Facing facing = Facing::All;
    base::Vec3d reference;      ///< unit vector for Skip and Flip; the gradient of the pass before for Refit
    const Axis* axis = nullptr; ///< of Part
    float sigma = 1;            ///< of Refit
    float scale = 1;            ///< supports are multiplied by it
    int shape = 0;              ///< channel of the supports' shapes (surfel/shape.h); 0: they are balls
    /// Weights over max(r^2, leastInterpolation) (surface/README 2.10), r the distance over the support.
    bool interpolating = false;
};

template <class T, int O>
struct Moments {
    int samples = 0;         ///< surfels with weight
    T unit = 0;              ///< sum theta unitOf(h), with h scaled
    base::Vec3<T> unitSlope; ///< sum grad theta unitOf(h): in double and from order 1 on, which boundaries need
    Jet<T, O> one;           ///< sum theta
    JetVec<T, O> q;          ///< sum theta q
    JetVec<T, O> n;          ///< sum theta n
    Jet<T, O> height;        ///< sum theta n.q
    Jet<T, O> square;        ///< sum theta |q|^2
    Jet<T, O> outer[6];      ///< sum theta n n^T or q q^T, by `sym`
};

/// Arrays of the clusters to sum over: each points at a cluster's channels (surfel_block.h). Those without support add
/// exact zeros.
using ClusterSpan = std::span<const float* const>;

template <int O>
void sum(ClusterSpan clusters, const base::Vec3f& x, const SumOptions& options, Moments<float, O>& out);
template <int O>
void sum(ClusterSpan clusters, const base::Vec3d& x, const SumOptions& options, Moments<double, O>& out);

extern template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 0>&);
extern template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 1>&);
extern template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 2>&);
extern template void sum(ClusterSpan, const base::Vec3d&, const SumOptions&, Moments<double, 0>&);
extern template void sum(ClusterSpan, const base::Vec3d&, const SumOptions&, Moments<double, 1>&);
extern template void sum(ClusterSpan, const base::Vec3d&, const SumOptions&, Moments<double, 2>&);
extern template void sum(ClusterSpan, const base::Vec3d&, const SumOptions&, Moments<double, 3>&);

} // namespace surface
