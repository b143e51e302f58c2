// The hot loop, compiled once per instruction set and chosen at run time (Google Highway).
//
// First the surfels in support are picked out of the clusters, in their order, into dense lanes (about a fifth of what
// the clusters hold has weight); then the sums run over the dense lanes alone. 16 virtual lanes: the i-th surfel in
// support goes to lane i mod 16 of the accumulators, whatever the width of the registers; on narrower ones the lanes
// are done in groups. Multiply-adds are explicit, roots and quotients exact, the reduction fixed. So AVX2 and AVX-512
// give the same bits, and so do all lists of clusters that hold the surfels in support in tree order.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/moments_kernel.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "core/surface/candidates.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Per instruction set, after the main header.
#include "core/surface/kernel_weights.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

constexpr std::size_t capacity = 128;            ///< dense surfels summed at once
constexpr std::size_t stride = capacity + lanes; ///< a compressed store may write a whole cluster behind them

/// Surfels in support in dense lanes. Only the first `count` of each row hold something.
struct Dense {
    /// Rows of the monomials that are picked as they are; Support takes the place of the 1.
    enum Row : int { Support = OneTerm };
    HWY_ALIGN float monomial[monomialCount(Outer::Normals)][stride];
    HWY_ALIGN float factor[factorCount(2)][stride];
    std::size_t count;
};

/// Appends those of the cluster that are in support.
HWY_INLINE void pick(const float* cluster, const KernelInput& in, Dense& out) {
    const D d;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        const float* c = cluster + first;
        const auto channel = [&](int k) { return hn::Load(d, c + k * lanes); };
        const V q[3] = {hn::Sub(channel(surfel::X), constant(in.x[0])), hn::Sub(channel(surfel::Y), constant(in.x[1])),
                        hn::Sub(channel(surfel::Z), constant(in.x[2]))};
        const V n[3] = {channel(surfel::NormalX), channel(surfel::NormalY), channel(surfel::NormalZ)};
        const V h = hn::Mul(channel(surfel::Support), constant(in.scale));
        const V distanceSq = hn::MulAdd(q[2], q[2], hn::MulAdd(q[1], q[1], hn::Mul(q[0], q[0])));
        M keep = hn::Lt(distanceSq, hn::Mul(h, h));
        if (in.facing == Facing::Skip) {
            const V facing =
                hn::MulAdd(n[2], constant(in.reference[2]),
                           hn::MulAdd(n[1], constant(in.reference[1]), hn::Mul(n[0], constant(in.reference[0]))));
            keep = hn::And(keep, hn::Gt(facing, constant(facingLimit)));
        }
        const auto append = [&](int row, V value) {
            hn::StoreU(hn::Compress(value, keep), d, out.monomial[row] + out.count);
        };
        append(Dense::Support, h);
        for (int k = 0; k < 3; ++k) {
            append(QTerm + k, q[k]);
            append(NTerm + k, n[k]);
        }
        out.count += hn::CountTrue(d, keep);
    }
}

/// Fills up to whole groups of 16 with surfels that add zeros.
HWY_INLINE void pad(Dense& dense) {
    const D d;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        const std::size_t at = dense.count + first;
        hn::StoreU(constant(1), d, dense.monomial[Dense::Support] + at);
        for (int k = QTerm; k < HeightTerm; ++k)
            hn::StoreU(hn::Zero(d), d, dense.monomial[k] + at);
    }
}

/// One group of lanes with its weights.
struct Lanes {
    V q[3], n[3], h, height, square, inverse;
    WeightLanes weight;
};

/// Weights of the surfels [at, at + lanes of D), zero from `end` on.
template <int order>
HWY_INLINE Lanes weigh(const KernelInput& in, const Dense& dense, std::size_t at, std::size_t end) {
    const D d;
    const auto row = [&](int k) { return hn::Load(d, dense.monomial[k] + at); };
    Lanes s{{row(QTerm), row(QTerm + 1), row(QTerm + 2)},
            {row(NTerm), row(NTerm + 1), row(NTerm + 2)},
            row(Dense::Support),
            {},
            {},
            {},
            {}};
    s.square = hn::MulAdd(s.q[2], s.q[2], hn::MulAdd(s.q[1], s.q[1], hn::Mul(s.q[0], s.q[0])));
    s.inverse = hn::Div(constant(1), s.h);
    s.weight = weightsAt<order>(hn::Mul(hn::Sqrt(s.square), s.inverse), in.weight, in.interpolating);
    V factor = constant(1);
    if (in.facing == Facing::Flip) {
        const V facing =
            hn::MulAdd(s.n[2], constant(in.reference[2]),
                       hn::MulAdd(s.n[1], constant(in.reference[1]), hn::Mul(s.n[0], constant(in.reference[0]))));
        for (V& each : s.n)
            each = hn::Xor(each, hn::And(facing, hn::SignBit(d)));
    }
    if (in.facing == Facing::Refit) {
        const V off[3] = {hn::Sub(s.n[0], constant(in.reference[0])), hn::Sub(s.n[1], constant(in.reference[1])),
                          hn::Sub(s.n[2], constant(in.reference[2]))};
        const V offSq = hn::MulAdd(off[2], off[2], hn::MulAdd(off[1], off[1], hn::Mul(off[0], off[0])));
        factor = hn::Exp(d, hn::Max(hn::Neg(hn::Mul(offSq, constant(in.inverseSigmaSquare))), constant(-80)));
    }
    // A mask in place of a comparison with the rest: lanes behind the end have weight too, being at distance 0.
    const M inside = hn::FirstN(d, at < end ? end - at : 0);
    factor = hn::IfThenElseZero(inside, factor);
    s.weight.theta = hn::Mul(s.weight.theta, factor);
    if constexpr (order >= 1)
        s.weight.slope = hn::Mul(s.weight.slope, factor);
    if constexpr (order >= 2)
        s.weight.bend = hn::Mul(s.weight.bend, factor);
    s.height = hn::MulAdd(s.n[2], s.q[2], hn::MulAdd(s.n[1], s.q[1], hn::Mul(s.n[0], s.q[0])));
    return s;
}

HWY_INLINE void accumulate(V& sum, V factor, V value) {
    sum = hn::MulAdd(factor, value, sum);
}

/// Accumulators in memory, one row of 16 lanes for each sum.
template <int order, Outer outer>
struct Rows {
    static constexpr int monomials = monomialCount(outer), sums = sumCount(order, outer), padded = (sums + 7) / 8 * 8;
    HWY_ALIGN float row[padded * lanes];
};

/// Order 0 without outer products: all in registers.
template <class R>
HWY_INLINE std::size_t sumPlain(const KernelInput& in, const Dense& dense, bool fresh, R& rows) {
    const D d;
    std::size_t samples = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        V acc[R::sums];
        for (int k = 0; k < R::sums; ++k)
            acc[k] = fresh ? hn::Zero(d) : hn::Load(d, rows.row + static_cast<std::size_t>(k) * lanes + first);
        for (std::size_t at = first; at < dense.count; at += lanes) {
            const Lanes s = weigh<0>(in, dense, at, dense.count);
            const V theta = s.weight.theta;
            samples += hn::CountTrue(d, hn::Gt(theta, hn::Zero(d)));
            acc[OneTerm] = hn::Add(acc[OneTerm], theta);
            for (int k = 0; k < 3; ++k) {
                accumulate(acc[QTerm + k], theta, s.q[k]);
                accumulate(acc[NTerm + k], theta, s.n[k]);
            }
            accumulate(acc[HeightTerm], theta, s.height);
            accumulate(acc[SquareTerm], theta, s.square);
            accumulate(acc[R::sums - 1], theta, s.h);
        }
        for (int k = 0; k < R::sums; ++k)
            hn::Store(acc[k], d, rows.row + static_cast<std::size_t>(k) * lanes + first);
    }
    return samples;
}

/// The factors and the monomials that are not picked as they are, for one group of lanes.
template <int order, Outer outer>
HWY_INLINE void prepare(const Lanes& s, std::size_t at, Dense& dense) {
    const D d;
    const auto factor = [&](int k, V value) { hn::Store(value, d, dense.factor[k] + at); };
    const auto monomial = [&](int k, V value) { hn::Store(value, d, dense.monomial[k] + at); };
    factor(ThetaFactor, s.weight.theta);
    const V u[3] = {hn::Mul(s.q[0], s.inverse), hn::Mul(s.q[1], s.inverse), hn::Mul(s.q[2], s.inverse)};
    if constexpr (order >= 1) {
        const V slope = hn::Mul(s.weight.slope, s.inverse);
        for (int k = 0; k < 3; ++k)
            factor(SlopeFactor + k, hn::Mul(slope, u[k]));
        if constexpr (order >= 2)
            factor(PlainSlopeFactor, hn::Mul(slope, s.inverse));
    }
    if constexpr (order >= 2) {
        const V bend = hn::Mul(hn::Mul(s.weight.bend, s.inverse), s.inverse);
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                factor(BendFactor + sym(k, l), hn::Mul(hn::Mul(bend, u[k]), u[l]));
    }
    for (int k = 0; k < 3; ++k)
        monomial(NTerm + k, s.n[k]);
    monomial(HeightTerm, s.height);
    monomial(SquareTerm, s.square);
    if constexpr (outer != Outer::None) {
        const V* y = outer == Outer::Normals ? s.n : s.q;
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                monomial(OuterTerm + sym(k, l), hn::Mul(y[k], y[l]));
    }
}

/// Factors times monomials, a factor at a time so that its accumulators fit into registers.
template <int order, Outer outer>
HWY_INLINE std::size_t sumProducts(const KernelInput& in, Dense& dense, bool fresh, Rows<order, outer>& rows) {
    using R = Rows<order, outer>;
    const D d;
    std::size_t samples = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        float* last = rows.row + (R::sums - 1) * lanes + first;
        V unit = fresh ? hn::Zero(d) : hn::Load(d, last);
        for (std::size_t at = first; at < dense.count; at += lanes) {
            const Lanes s = weigh<order>(in, dense, at, dense.count);
            samples += hn::CountTrue(d, hn::Gt(s.weight.theta, hn::Zero(d)));
            accumulate(unit, s.weight.theta, s.h);
            prepare<order, outer>(s, at, dense);
        }
        hn::Store(unit, d, last);
        for (std::size_t f = 0; f < factorCount(order); ++f) {
            float* row = rows.row + f * R::monomials * lanes + first;
            V acc[R::monomials];
            for (std::size_t k = 0; k < R::monomials; ++k)
                acc[k] = fresh ? hn::Zero(d) : hn::Load(d, row + k * lanes);
            for (std::size_t at = first; at < dense.count; at += lanes) {
                const V factor = hn::Load(d, dense.factor[f] + at);
                acc[OneTerm] = hn::Add(acc[OneTerm], factor);
                for (std::size_t k = QTerm; k < R::monomials; ++k)
                    accumulate(acc[k], factor, hn::Load(d, dense.monomial[k] + at));
            }
            for (std::size_t k = 0; k < R::monomials; ++k)
                hn::Store(acc[k], d, row + k * lanes);
        }
    }
    return samples;
}

/// Adds up the 16 lanes of 4 sums: 16 -> 8 -> 4 by halves, then even and odd; the same adds on every instruction set.
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void reduceFour(const float* rows, float* out) {
    for (int k = 0; k < 4; ++k) {
        const float* row = rows + k * lanes;
        float r[4];
        for (int i = 0; i < 4; ++i)
            r[i] = (row[i] + row[i + 8]) + (row[i + 4] + row[i + 12]);
        out[k] = (r[0] + r[2]) + (r[1] + r[3]);
    }
}
#else
HWY_INLINE void reduceFour(const float* rows, float* out) {
    const hn::FixedTag<float, 4> d4;
    using V4 = hn::Vec<hn::FixedTag<float, 4>>;
    V4 r[4];
    for (int k = 0; k < 4; ++k) {
        const float* row = rows + k * lanes;
        r[k] = hn::Add(hn::Add(hn::Load(d4, row), hn::Load(d4, row + 8)),
                       hn::Add(hn::Load(d4, row + 4), hn::Load(d4, row + 12)));
    }
    // (a0+a2, b0+b2, a1+a3, b1+b3), and c, d likewise
    const V4 ab = hn::Add(hn::InterleaveLower(d4, r[0], r[1]), hn::InterleaveUpper(d4, r[0], r[1]));
    const V4 cd = hn::Add(hn::InterleaveLower(d4, r[2], r[3]), hn::InterleaveUpper(d4, r[2], r[3]));
    hn::Store(hn::Add(hn::ConcatLowerLower(d4, cd, ab), hn::ConcatUpperUpper(d4, cd, ab)), d4, out);
}
#endif

/// Sums what is dense. Of a list that goes on, whole groups of 16 only; the rest moves to the front.
template <int order, Outer outer>
HWY_INLINE std::size_t flush(const KernelInput& in, Dense& dense, bool fresh, Rows<order, outer>& rows) {
    if constexpr (order == 0 && outer == Outer::None)
        return sumPlain(in, dense, fresh, rows);
    else
        return sumProducts<order, outer>(in, dense, fresh, rows);
}

template <int order, Outer outer>
int sumAll(const KernelInput& in, float* sums) {
    using R = Rows<order, outer>;
    Dense dense;
    dense.count = 0;
    R rows;
    bool fresh = true;
    std::size_t samples = 0;
    for (std::size_t c = 0; c < in.clusterCount; ++c) {
        pick(in.clusters[c], in, dense);
        if (dense.count < capacity)
            continue;
        const std::size_t left = dense.count - capacity;
        dense.count = capacity;
        samples += flush<order, outer>(in, dense, fresh, rows);
        fresh = false;
        dense.count = left;
        for (int k = 0; k < HeightTerm; ++k)
            std::copy_n(dense.monomial[k] + capacity, lanes, dense.monomial[k]);
    }
    pad(dense);
    samples += flush<order, outer>(in, dense, fresh, rows);
    for (int k = 0; k < R::sums; k += 4)
        reduceFour(rows.row + k * lanes, sums + k);
    return static_cast<int>(samples);
}

template <Outer outer>
int sumOfOrder(int order, const KernelInput& in, float* sums) {
    return order == 0   ? sumAll<0, outer>(in, sums)
           : order == 1 ? sumAll<1, outer>(in, sums)
                        : sumAll<2, outer>(in, sums);
}

int sumDispatched(int order, Outer outer, const KernelInput& in, float* sums) {
    switch (outer) {
    case Outer::None:
        return sumOfOrder<Outer::None>(order, in, sums);
    case Outer::Normals:
        return sumOfOrder<Outer::Normals>(order, in, sums);
    case Outer::Offsets:
        break;
    }
    return sumOfOrder<Outer::Offsets>(order, in, sums);
}

/// distance(x, box) < support for boxes in lanes, by the same operations as the tree's own test.
void supportDispatched(const float* bounds, std::size_t groups, const base::Vec3f& x, std::uint16_t* bits) {
    const D d;
    const int width = static_cast<int>(hn::Lanes(d));
    const V at[3] = {hn::Set(d, x.x), hn::Set(d, x.y), hn::Set(d, x.z)};
    for (std::size_t g = 0; g < groups; ++g, bounds += 7 * lanes) {
        unsigned found = 0;
        for (int first = 0; first < lanes; first += width) {
            V square[3];
            for (int k = 0; k < 3; ++k) {
                const V below = hn::Sub(hn::LoadU(d, bounds + k * lanes + first), at[k]);
                const V above = hn::Sub(at[k], hn::LoadU(d, bounds + (3 + k) * lanes + first));
                const V away = hn::Max(hn::Max(below, above), hn::Zero(d));
                square[k] = hn::Mul(away, away);
            }
            const V support = hn::LoadU(d, bounds + 6 * lanes + first);
            const V distanceSq = hn::Add(hn::Add(square[0], square[1]), square[2]);
            std::uint8_t mask[8] = {};
            hn::StoreMaskBits(d, hn::Lt(distanceSq, hn::Mul(support, support)), mask);
            found |= (mask[0] | static_cast<unsigned>(mask[1]) << 8) << first;
        }
        bits[g] = static_cast<std::uint16_t>(found);
    }
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(sumDispatched);
HWY_EXPORT(supportDispatched);

int sumKernel(int order, Outer outer, const KernelInput& in, float* sums) {
    return HWY_DYNAMIC_DISPATCH(sumDispatched)(order, outer, in, sums);
}

void supportKernel(const float* bounds, std::size_t groups, const base::Vec3f& x, std::uint16_t* bits) {
    HWY_DYNAMIC_DISPATCH(supportDispatched)(bounds, groups, x, bits);
}

} // namespace surface
#endif
