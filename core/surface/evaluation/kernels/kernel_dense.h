// Surfels in support picked out of their clusters into dense lanes, and their weights there (moments_kernel.cpp).
// Included once per instruction set, from within a file that Highway compiles several times, after <hwy/highway.h>.
#if defined(POINTCLAY_KERNEL_DENSE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_KERNEL_DENSE_H
#undef POINTCLAY_KERNEL_DENSE_H
#else
#define POINTCLAY_KERNEL_DENSE_H
#endif

#include "core/surface/evaluation/kernels/kernel_weights.h"
#include "core/surfel/surfel_block.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

constexpr std::size_t capacity = 128;            ///< dense surfels summed at once
constexpr std::size_t stride = capacity + lanes; ///< a compressed store may write a whole cluster behind them

/// Surfels in support in dense lanes.
struct Dense {
    /// Rows of the monomials that are picked as they are; Support takes the place of the 1.
    enum Row : int { Support = OneTerm };
    HWY_ALIGN float monomial[monomialCount(Outer::Normals)][stride];
    HWY_ALIGN float factor[factorCount(2)][stride];
    HWY_ALIGN float shape[3][stride]; ///< of ellipsoids
};

/// Puts those of the cluster that are in support behind the `count` first; returns how many there are then.
template <bool shaped>
HWY_INLINE std::size_t pick(const float* cluster, const KernelInput& in, std::size_t count, Dense& out) {
    const D d;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        const float* c = cluster + first;
        const V3 q = minus(load3(c, lanes), in.x), n = load3(c + surfel::NormalX * lanes, lanes);
        const V h = hn::Mul(hn::Load(d, c + surfel::Support * lanes), constant(in.scale));
        V square = dot(q, q);
        V3 b;
        if constexpr (shaped) {
            b = load3(c + in.shape * lanes, lanes);
            square = shapedSquare(square, dot(b, q));
        }
        M keep = hn::Lt(square, hn::Mul(h, h));
        if (in.facing == Facing::Skip)
            keep = hn::And(keep, hn::Gt(dot(n, in.reference), constant(facingLimit)));
        if (in.facing == Facing::Part)
            keep = hn::And(keep, hn::Gt(dot(n, in.reference), constant(-partingLimit)));
        const Packing packing(keep);
        const auto append = [&](int row, V value) { hn::StoreU(packing.pack(value), d, out.monomial[row] + count); };
        append(Dense::Support, h);
        append(QTerm, q.x), append(QTerm + 1, q.y), append(QTerm + 2, q.z);
        append(NTerm, n.x), append(NTerm + 1, n.y), append(NTerm + 2, n.z);
        if constexpr (shaped) {
            const auto appendShape = [&](int row, V value) {
                hn::StoreU(packing.pack(value), d, out.shape[row] + count);
            };
            appendShape(0, b.x), appendShape(1, b.y), appendShape(2, b.z);
        }
        count += hn::CountTrue(d, keep);
    }
    return count;
}

/// Fills up to whole groups of 16 with surfels that add zeros.
template <bool shaped>
HWY_INLINE void pad(std::size_t count, Dense& dense) {
    const D d;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        hn::StoreU(constant(1), d, dense.monomial[Dense::Support] + count + first);
        unrolled<HeightTerm - QTerm>(
            [&](auto k) { hn::StoreU(hn::Zero(d), d, dense.monomial[QTerm + k] + count + first); });
        if constexpr (shaped)
            unrolled<3>([&](auto k) { hn::StoreU(hn::Zero(d), d, dense.shape[k] + count + first); });
    }
}

/// Of Facing::Part: weights times derivatives of the step by the normal's part along the axis.
struct PartLanes {
    V theta, slope, bend; ///< theta and slope times the first derivative, theta times the second
};

/// One group of lanes with its weights.
struct Lanes {
    V3 q, n;
    V h, height, square, inverse;
    V3 b;          ///< of ellipsoids
    V along, unit; ///< b.q; what the boundary limit counts of h
    WeightLanes weight;
    PartLanes part;
};

/// Weights times the step of t = 1/2 + n.axis / 2 partingLimit.
template <int order>
HWY_INLINE void takePart(const KernelInput& in, Lanes& s) {
    constexpr float rise = 0.5f / partingLimit;
    const V zero = hn::Zero(D()), one = constant(1);
    const V t = hn::Min(one, hn::Max(zero, hn::MulAdd(dot(s.n, in.reference), constant(rise), constant(0.5f))));
    const V rest = hn::Sub(one, t), square = hn::Mul(t, t);
    const V inner = hn::MulAdd(hn::MulAdd(constant(6), t, constant(-15)), t, constant(10));
    if constexpr (order >= 1) {
        const V d = hn::Mul(constant(30 * rise), hn::Mul(square, hn::Mul(rest, rest)));
        s.part.theta = hn::Mul(s.weight.theta, d);
        s.part.slope = hn::Mul(s.weight.slope, d);
    }
    if constexpr (order >= 2) {
        const V dd = hn::Mul(hn::Mul(constant(60 * rise * rise), hn::Mul(t, rest)), hn::Sub(rest, t));
        s.part.bend = hn::Mul(s.weight.theta, dd);
    }
    scale<order>(hn::Mul(hn::Mul(square, t), inner), s.weight);
}

/// Weights of the surfels from `at` on, zero from `end` on.
template <int order, bool shaped>
HWY_INLINE Lanes weigh(const KernelInput& in, const Dense& dense, std::size_t at, std::size_t end) {
    const D d;
    Lanes s;
    s.q = load3(dense.monomial[QTerm] + at, stride);
    s.n = load3(dense.monomial[NTerm] + at, stride);
    s.h = hn::Load(d, dense.monomial[Dense::Support] + at);
    s.square = dot(s.q, s.q);
    s.inverse = hn::Div(constant(1), s.h);
    V metric = s.square;
    s.unit = s.h;
    if constexpr (shaped) {
        s.b = load3(dense.shape[0] + at, stride);
        s.along = dot(s.b, s.q);
        s.unit = shapedUnit(s.h, s.b);
        metric = shapedSquare(metric, s.along);
    }
    s.weight = weightsAt<order>(hn::Mul(hn::Sqrt(metric), s.inverse), in.weight, in.interpolating);
    if (in.facing == Facing::Flip) {
        const V flip = hn::And(dot(s.n, in.reference), hn::SignBit(d));
        s.n = {hn::Xor(s.n.x, flip), hn::Xor(s.n.y, flip), hn::Xor(s.n.z, flip)};
    }
    if (in.facing == Facing::Refit) {
        const V3 off = minus(s.n, in.reference);
        const V exponent = hn::Neg(hn::Mul(dot(off, off), constant(in.inverseSigmaSquare)));
        scale<order>(hn::Exp(d, hn::Max(exponent, constant(-80))), s.weight);
    }
    // What pads the lanes lies at distance 0 and has weight until here.
    const M inside = hn::FirstN(d, at < end ? end - at : 0);
    s.weight.theta = hn::IfThenElseZero(inside, s.weight.theta);
    if constexpr (order >= 1)
        s.weight.slope = hn::IfThenElseZero(inside, s.weight.slope);
    if constexpr (order >= 2)
        s.weight.bend = hn::IfThenElseZero(inside, s.weight.bend);
    if (in.facing == Facing::Part)
        takePart<order>(in, s);
    s.height = dot(s.n, s.q);
    return s;
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
