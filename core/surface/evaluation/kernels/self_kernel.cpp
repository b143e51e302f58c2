// Evaluation at the surfels of a cluster, or at any 16 positions, compiled once per instruction set and chosen at run
// time (Google Highway).
//
// The positions are the lanes, so that lanes never meet: no reduction, and the same bits at every width. A surfel
// around them is one step of the loop, with the same operations in all lanes. First those that reach the box of the
// positions are picked out of the clusters, in tree order; the others would add exact zeros.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/evaluation/kernels/self_kernel.cpp"
#include "core/surface/evaluation/kernels/self_kernel.h"
#include "core/base/instruction_sets.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Per instruction set, after the main header.
#include "core/surface/evaluation/kernels/kernel_pick.h"
#include "core/surface/evaluation/kernels/kernel_weights.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

/// Rows are the channels, then 1 / h; of ellipsoids b and the unit.
enum AroundRow : int { InverseSupport = surfel::Support + 1, Shape, Unit = Shape + 3 };
template <bool shaped>
using Around = Picked<selfRows(shaped)>;

template <bool shaped>
HWY_INLINE Around<shaped> pickAround(const SelfInput& in, float* scratch) {
    const BoxLanes box(in.box);
    return pickFrom<selfRows(shaped)>(in.around, scratch, [&](const float* c, const auto& append) {
        const V3 p = load3(c, lanes), n = load3(c + surfel::NormalX * lanes, lanes);
        const V h = hn::Mul(hn::Load(D(), c + surfel::Support * lanes), constant(in.scale));
        const V reach = hn::Mul(h, constant(queryReach(1)));
        const M keep = hn::Lt(box.distanceSq(p), hn::Mul(reach, reach));
        const V inverse = hn::Div(constant(1), h);
        if constexpr (shaped) {
            const V3 b = load3(c + in.shape * lanes, lanes);
            append(keep, p.x, p.y, p.z, n.x, n.y, n.z, h, inverse, b.x, b.y, b.z, shapedUnit(h, b));
        } else {
            append(keep, p.x, p.y, p.z, n.x, n.y, n.z, h, inverse);
        }
    });
}

/// One surfel around, against all positions: y = x - p points away from it.
template <bool shaped>
struct Pair {
    V3 y, n, b;
    V squareY, along, r, inverse;

    HWY_INLINE Pair(const Around<shaped>& around, std::size_t i, const V3& x) {
        const auto channel = [&](int k) { return constant(around.row[k][i]); };
        y = {hn::Sub(x.x, channel(surfel::X)), hn::Sub(x.y, channel(surfel::Y)), hn::Sub(x.z, channel(surfel::Z))};
        n = {channel(surfel::NormalX), channel(surfel::NormalY), channel(surfel::NormalZ)};
        inverse = channel(InverseSupport);
        squareY = dot(y, y);
        V metric = squareY;
        if constexpr (shaped) {
            b = {channel(Shape), channel(Shape + 1), channel(Shape + 2)};
            along = dot(b, y);
            metric = shapedSquare(metric, along);
        }
        r = hn::Mul(hn::Sqrt(metric), inverse);
    }
    /// (I + b b^T) y
    HWY_INLINE V3 slope() const {
        if constexpr (shaped)
            return {hn::MulAdd(b.x, along, y.x), hn::MulAdd(b.y, along, y.y), hn::MulAdd(b.z, along, y.z)};
        else
            return y;
    }
    /// Beyond the support Wendland's weights vanish by themselves.
    template <Weight weight, int order>
    HWY_INLINE WeightLanes weights() const {
        WeightLanes w = weightsAt<order>(r, weight, false);
        if constexpr (weight == Weight::Gaussian) {
            const M inside = hn::Lt(r, constant(1));
            w.theta = hn::IfThenElseZero(inside, w.theta);
            if constexpr (order >= 1)
                w.slope = hn::IfThenElseZero(inside, w.slope);
        }
        return w;
    }
};

/// Sums of theta times 1, y, n, n.y, |y|^2 and h, and what follows from them.
struct Values {
    V one, yx, yy, yz, nx, ny, nz, height, square, unit;
    V inverseWeight, inverseLength, length; ///< of the summed normals
    V3 away, normal;                        ///< x - c, n

    template <Weight weight, bool shaped>
    HWY_INLINE void sum(const Around<shaped>& around, const V3& x) {
        one = yx = yy = yz = nx = ny = nz = height = square = unit = hn::Zero(D());
        for (std::size_t i = 0; i < around.count; ++i) {
            const Pair<shaped> s(around, i, x);
            const V theta = s.template weights<weight, 0>().theta;
            one = hn::Add(one, theta);
            accumulate(yx, theta, s.y.x), accumulate(yy, theta, s.y.y), accumulate(yz, theta, s.y.z);
            accumulate(nx, theta, s.n.x), accumulate(ny, theta, s.n.y), accumulate(nz, theta, s.n.z);
            accumulate(height, theta, dot(s.n, s.y));
            accumulate(square, theta, s.squareY);
            accumulate(unit, theta, constant(around.row[shaped ? int(Unit) : int(surfel::Support)][i]));
        }
        if (weight == Weight::Gaussian)
            unit = hn::Mul(unit, constant(1 / gaussianReach));
    }
    HWY_INLINE void derive() {
        const auto times = [](const V3& a, V s) { return V3{hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; };
        const V3 normals{nx, ny, nz};
        inverseWeight = hn::Div(constant(1), one);
        away = times({yx, yy, yz}, inverseWeight);
        length = hn::Sqrt(dot(normals, normals));
        inverseLength = hn::Div(constant(1), length);
        normal = times(normals, inverseLength);
    }
};

/// f = (1-mu) n.d + mu sum theta n_i.y_i / w and all else that values tell; bits of the special ones.
HWY_INLINE unsigned storeValues(const SelfInput& in, const Values& s, const V3& x, std::size_t first, SelfLanes& out) {
    const D d;
    const auto store = [&](V v, float* to) { hn::Store(v, d, to + first); };
    const V plain = hn::Mul(dot(s.normal, s.away), constant(1 - in.mu));
    store(hn::MulAdd(hn::Mul(s.height, s.inverseWeight), constant(in.mu), plain), out.value);
    store(s.one, out.weight);
    const V unit = hn::Mul(s.unit, s.inverseWeight), agreement = hn::Mul(s.length, s.inverseWeight);
    store(unit, out.unit);
    store(agreement, out.agreement);
    const V apart = dot(s.away, s.away), offCentre = hn::Sqrt(apart);
    store(offCentre, out.offCentre);
    store(hn::Sub(x.x, s.away.x), out.centroid[0]);
    store(hn::Sub(x.y, s.away.y), out.centroid[1]);
    store(hn::Sub(x.z, s.away.z), out.centroid[2]);
    store(s.normal.x, out.normal[0]), store(s.normal.y, out.normal[1]), store(s.normal.z, out.normal[2]);

    const auto bits = [&](M mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, mask, bytes);
        return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
    };
    const unsigned beyond = bits(hn::Gt(offCentre, hn::Mul(constant(in.boundaryLimit), unit)));
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
        out.status[first + lane] = beyond >> lane & 1 ? Status::BeyondBoundary : Status::Ok;
    // No weight is above 1: where they sum to more than 2 there are three surfels.
    const V square = hn::Mul(s.square, s.inverseWeight);
    const V spread = hn::Mul(constant(in.leastSpread), hn::Max(square, hn::Mul(unit, unit)));
    const M usual = hn::And(hn::And(hn::Gt(s.one, constant(2)), hn::Ge(agreement, constant(in.leastAgreement))),
                            hn::Gt(hn::Sub(square, apart), spread));
    return ~bits(usual) & ((1u << hn::Lanes(d)) - 1);
}

/// The gradient, in a second pass that knows n, d and w. With theta_,k = -a y_k it is one sum:
///     grad f = (1-mu) n + mu m / w - sum a_i g_i y_i
///     g_i = (1-mu) [ n.(y_i - d) / w + v.n_i ] + mu (n_i.y_i - H / w) / w,   v = (d - n (n.d)) / |m|,  H = sum theta
///     n.y
/// and d^T (grad n) d = - sum a_i (y_i.d) (n_i.v).
template <Weight weight, bool shaped, bool bend>
HWY_INLINE void storeGradients(const SelfInput& in, const Around<shaped>& around, const Values& s, const V3& x,
                               std::size_t first, SelfLanes& out) {
    const D d;
    const V flat = constant(1 - in.mu), symmetric = hn::Mul(constant(in.mu), s.inverseWeight);
    const V across = hn::Mul(flat, s.inverseWeight), height = dot(s.normal, s.away);
    const V3 n{hn::Mul(s.normal.x, across), hn::Mul(s.normal.y, across), hn::Mul(s.normal.z, across)};
    const auto tangent = [&](V away, V normal) {
        return hn::Mul(hn::Mul(flat, s.inverseLength), hn::NegMulAdd(normal, height, away));
    };
    const V3 v{tangent(s.away.x, s.normal.x), tangent(s.away.y, s.normal.y), tangent(s.away.z, s.normal.z)};
    const V same = hn::MulAdd(hn::Mul(s.height, s.inverseWeight), symmetric, dot(n, s.away));
    const auto turn = [&](V away, V normal) { return hn::Mul(s.inverseLength, hn::NegMulAdd(normal, height, away)); };
    const V3 turning{turn(s.away.x, s.normal.x), turn(s.away.y, s.normal.y), turn(s.away.z, s.normal.z)};
    V gx = hn::Zero(d), gy = gx, gz = gx, bent = gx;
    for (std::size_t i = 0; i < around.count; ++i) {
        const Pair<shaped> pair(around, i, x);
        const V slope = pair.template weights<weight, 1>().slope;
        const V a = hn::Mul(hn::Mul(slope, pair.inverse), pair.inverse);
        const V3 along{hn::MulAdd(symmetric, pair.y.x, v.x), hn::MulAdd(symmetric, pair.y.y, v.y),
                       hn::MulAdd(symmetric, pair.y.z, v.z)};
        const V g = hn::Add(hn::Sub(dot(n, pair.y), same), dot(pair.n, along));
        const V ag = hn::Mul(a, g);
        const V3 way = pair.slope();
        accumulate(gx, ag, way.x), accumulate(gy, ag, way.y), accumulate(gz, ag, way.z);
        if constexpr (bend)
            accumulate(bent, hn::Mul(a, dot(s.away, way)), dot(pair.n, turning));
    }
    if constexpr (bend)
        hn::Store(hn::Neg(bent), d, out.bend + first);
    const auto store = [&](V summed, V normal, V sum, float* to) {
        hn::Store(hn::Sub(hn::MulAdd(symmetric, summed, hn::Mul(flat, normal)), sum), d, to + first);
    };
    store(s.nx, s.normal.x, gx, out.gradient[0]);
    store(s.ny, s.normal.y, gy, out.gradient[1]);
    store(s.nz, s.normal.z, gz, out.gradient[2]);
}

template <Weight weight, bool shaped>
unsigned evaluateAll(const SelfInput& in, float* scratch, SelfLanes& out) {
    const Around<shaped> around = pickAround<shaped>(in, scratch);
    unsigned special = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D())) {
        const V3 x = load3(in.cluster + first, lanes);
        Values values;
        values.sum<weight, shaped>(around, x);
        values.derive();
        special |= storeValues(in, values, x, first, out) << first;
        if (in.bend)
            storeGradients<weight, shaped, true>(in, around, values, x, first, out);
        else if (in.gradient)
            storeGradients<weight, shaped, false>(in, around, values, x, first, out);
    }
    return special;
}

template <bool shaped>
unsigned evaluateShape(const SelfInput& in, float* scratch, SelfLanes& out) {
    switch (in.weight) {
    case Weight::Wendland:
        return evaluateAll<Weight::Wendland, shaped>(in, scratch, out);
    case Weight::WendlandC4:
        return evaluateAll<Weight::WendlandC4, shaped>(in, scratch, out);
    case Weight::Gaussian:
        break;
    }
    return evaluateAll<Weight::Gaussian, shaped>(in, scratch, out);
}

unsigned selfDispatched(const SelfInput& in, float* scratch, SelfLanes& out) {
    return in.shape > 0 ? evaluateShape<true>(in, scratch, out) : evaluateShape<false>(in, scratch, out);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(selfDispatched);

unsigned selfKernel(const SelfInput& in, float* scratch, SelfLanes& out) {
    return HWY_DYNAMIC_DISPATCH(selfDispatched)(in, scratch, out);
}

} // namespace surface
#endif
