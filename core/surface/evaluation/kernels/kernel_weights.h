// Weights in lanes (surface/README 2.1, 2.10), for the kernels of this room. Included once per instruction set, from
// within a file that Highway compiles several times, after <hwy/highway.h>.
//
// Derivatives come free of length: with u = q / h, theta_,k = (slope / h) u_k and
// theta_,kl = (bend u_k u_l - slope delta_kl) / h^2, so that nothing leaves the range of float while 1 / h^2 stays in.
#if defined(POINTCLAY_KERNEL_WEIGHTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_KERNEL_WEIGHTS_H
#undef POINTCLAY_KERNEL_WEIGHTS_H
#else
#define POINTCLAY_KERNEL_WEIGHTS_H
#endif

#include "core/surface/evaluation/kernels/kernel_lanes.h"
#include "core/surface/evaluation/moments_float.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
/// Those beyond the order asked for stay as they are.
struct WeightLanes {
    V theta, slope, bend;
};

/// With t = 1 - r: theta = t^4 (5 - 4t), slope 20 t^3, bend 60 t^2 / r.
template <int order>
HWY_INLINE void wendlandC2(V r, V t, WeightLanes& out) {
    const V t2 = hn::Mul(t, t), t3 = hn::Mul(t2, t);
    out.theta = hn::Mul(hn::Mul(t2, t2), hn::NegMulAdd(constant(4), t, constant(5)));
    if constexpr (order >= 1)
        out.slope = hn::Mul(constant(20), t3);
    if constexpr (order >= 2) {
        const V bend = hn::Div(hn::Mul(constant(60), t2), hn::Max(r, constant(1e-14f)));
        out.bend = hn::IfThenElseZero(hn::Gt(r, constant(1e-14f)), bend);
    }
}

/// theta = t^6 (35 r^2 + 18 r + 3) / 3, slope 56/3 t^5 (5 r + 1), bend 560 t^4.
template <int order>
HWY_INLINE void wendlandC4(V r, V t, WeightLanes& out) {
    const V t2 = hn::Mul(t, t), t4 = hn::Mul(t2, t2);
    const V factor = hn::MulAdd(hn::MulAdd(constant(35.0f / 3), r, constant(6)), r, constant(1));
    out.theta = hn::Mul(hn::Mul(t4, t2), factor);
    if constexpr (order >= 1)
        out.slope = hn::Mul(hn::Mul(t4, t), hn::MulAdd(constant(280.0f / 3), r, constant(56.0f / 3)));
    if constexpr (order >= 2)
        out.bend = hn::Mul(constant(560), t4);
}

/// With s = r gaussianReach: theta = exp(-s^2), slope 2 theta gaussianReach^2, bend 4 theta gaussianReach^4.
template <int order>
HWY_INLINE void gaussian(V r, WeightLanes& out) {
    constexpr float reachSq = gaussianReach * gaussianReach;
    const V exponent = hn::Mul(hn::Mul(r, r), constant(-reachSq));
    out.theta = hn::Exp(D(), exponent);
    if constexpr (order >= 1)
        out.slope = hn::Mul(out.theta, constant(2 * reachSq));
    if constexpr (order >= 2)
        out.bend = hn::Mul(out.theta, constant(4 * reachSq * reachSq));
}

/// theta / m with m = max(r^2, leastInterpolation), by the product rule where m moves:
/// slope/m + 2 theta/m^2, bend/m + 4 slope/m^2 + 8 theta/m^3.
template <int order>
HWY_INLINE void interpolate(V r, WeightLanes& w) {
    const V square = hn::Mul(r, r);
    const V inverse = hn::Div(constant(1), hn::Max(square, constant(leastInterpolation)));
    const V moving = hn::IfThenElseZero(hn::Gt(square, constant(leastInterpolation)), inverse);
    if constexpr (order >= 2) {
        const V inner = hn::MulAdd(hn::Mul(constant(8), w.theta), moving, hn::Mul(constant(4), w.slope));
        w.bend = hn::Mul(hn::MulAdd(inner, moving, w.bend), inverse);
    }
    if constexpr (order >= 1)
        w.slope = hn::Mul(hn::MulAdd(hn::Mul(constant(2), w.theta), moving, w.slope), inverse);
    w.theta = hn::Mul(w.theta, inverse);
}

template <int order>
HWY_INLINE void scale(V factor, WeightLanes& w) {
    w.theta = hn::Mul(w.theta, factor);
    if constexpr (order >= 1)
        w.slope = hn::Mul(w.slope, factor);
    if constexpr (order >= 2)
        w.bend = hn::Mul(w.bend, factor);
}

/// Weights at r = |q| / h < 1.
template <int order>
HWY_INLINE WeightLanes weightsAt(V r, Weight weight, bool interpolating) {
    WeightLanes out{hn::Zero(D()), hn::Zero(D()), hn::Zero(D())};
    const V t = hn::Max(hn::Zero(D()), hn::Sub(constant(1), r));
    switch (weight) {
    case Weight::Wendland:
        wendlandC2<order>(r, t, out);
        break;
    case Weight::WendlandC4:
        wendlandC4<order>(r, t, out);
        break;
    case Weight::Gaussian:
        gaussian<order>(r, out);
        break;
    }
    if (interpolating)
        interpolate<order>(r, out);
    return out;
}

/// |q|^2 + (b.q)^2; and what the boundary limit counts of a radius: h / (1 + |b|^2)^(1/4). Both exact for b = 0.
HWY_INLINE V shapedSquare(V square, V along) {
    return hn::MulAdd(along, along, square);
}
HWY_INLINE V shapedUnit(V h, const V3& b) {
    const V root = hn::Sqrt(hn::Sqrt(hn::MulAdd(b.z, b.z, hn::MulAdd(b.y, b.y, hn::MulAdd(b.x, b.x, constant(1))))));
    return hn::Div(h, root);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
