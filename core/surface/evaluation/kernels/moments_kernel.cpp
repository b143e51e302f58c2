// The sums at a position, compiled once per instruction set and chosen at run time (Google Highway).
//
// Two ways to sum, each always used for the same sums:
//   - plain values of cheap weights over all lanes of the clusters, though only about a fifth have weight: putting
//     those together would cost as much as it saves;
//   - all else over dense lanes: first the surfels in support are picked out of the clusters, in their order.
// 16 virtual lanes, whatever the width of the registers; on narrower ones they are done in groups. In the first way a
// surfel's lane is its place in its cluster; in the second the i-th surfel in support goes to lane i mod 16.
// Multiply-adds are explicit, roots and quotients exact, the reduction fixed. So AVX2 and AVX-512 give the same bits,
// and so do all lists of clusters that hold the surfels in support in tree order.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/evaluation/kernels/moments_kernel.cpp"
#include "core/base/instruction_sets.h"
#include "core/surface/evaluation/candidates.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Per instruction set, after the main header.
#include "core/surface/evaluation/kernels/kernel_dense.h"
#include "core/surface/evaluation/kernels/kernel_rows.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

/// The sums of order 0 without outer products, in their order.
struct PlainSums {
    V one, qx, qy, qz, nx, ny, nz, height, square, unit;

    HWY_INLINE PlainSums() { one = qx = qy = qz = nx = ny = nz = height = square = unit = hn::Zero(D()); }
    HWY_INLINE void add(const Lanes& s) {
        const V theta = s.weight.theta;
        one = hn::Add(one, theta);
        accumulate(qx, theta, s.q.x), accumulate(qy, theta, s.q.y), accumulate(qz, theta, s.q.z);
        accumulate(nx, theta, s.n.x), accumulate(ny, theta, s.n.y), accumulate(nz, theta, s.n.z);
        accumulate(height, theta, s.height);
        accumulate(square, theta, s.square);
        accumulate(unit, theta, s.unit);
    }
    template <class R>
    HWY_INLINE void put(std::size_t first, bool fresh, R& rows) const {
        const auto store = [&](std::size_t k, V sum) { rows.put(k, first, sum, fresh); };
        store(OneTerm, one);
        store(QTerm, qx), store(QTerm + 1, qy), store(QTerm + 2, qz);
        store(NTerm, nx), store(NTerm + 1, ny), store(NTerm + 2, nz);
        store(HeightTerm, height), store(SquareTerm, square), store(R::sums - 1, unit);
    }
};

/// Order 0 without outer products: all in registers.
template <bool shaped, class R>
HWY_INLINE std::size_t sumPlain(const KernelInput& in, const Dense& dense, std::size_t count, bool fresh, R& rows) {
    const D d;
    std::size_t samples = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        PlainSums sums;
        for (std::size_t at = first; at < count; at += lanes) {
            const Lanes s = weigh<0, shaped>(in, dense, at, count);
            samples += hn::CountTrue(d, hn::Gt(s.weight.theta, hn::Zero(d)));
            sums.add(s);
        }
        sums.put(first, fresh, rows);
    }
    return samples;
}

/// Adds to the factors what the axis of Facing::Part does to them as it moves.
template <int order>
HWY_INLINE void prepareParts(const Axis& axis, const Lanes& s, const V3& u, std::size_t place, Dense& dense) {
    const D d;
    const auto along = [&](const base::Vec3d& v) {
        const float narrow[3] = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
        return dot(s.n, narrow);
    };
    const auto add = [&](std::size_t k, V value) {
        float* to = dense.factor[k] + place;
        hn::Store(hn::Add(hn::Load(d, to), value), d, to);
    };
    const V3 turn{along(axis.slope[0]), along(axis.slope[1]), along(axis.slope[2])};
    unrolled<3>([&](auto k) { add(SlopeFactor + k, hn::Mul(s.part.theta, at<k>(turn))); });
    if constexpr (order >= 2) {
        const V slope = hn::Mul(s.part.slope, s.inverse);
        forPairs([&](auto k, auto l) {
            const V mixed = hn::MulAdd(at<k>(u), at<l>(turn), hn::Mul(at<l>(u), at<k>(turn)));
            const V bent = hn::Mul(s.part.theta, along(axis.bend[sym(k, l)]));
            const V turned = hn::Mul(s.part.bend, hn::Mul(at<k>(turn), at<l>(turn)));
            add(BendFactor + sym(k, l), hn::Add(hn::MulAdd(slope, mixed, bent), turned));
        });
    }
}

/// The factors and the monomials that are not picked as they are, for one group of lanes.
template <int order, Outer outer, bool shaped>
HWY_INLINE void prepare(const KernelInput& in, const Lanes& s, std::size_t place, Dense& dense) {
    const D d;
    const auto factor = [&](std::size_t k, V value) { hn::Store(value, d, dense.factor[k] + place); };
    const auto monomial = [&](std::size_t k, V value) { hn::Store(value, d, dense.monomial[k] + place); };
    factor(ThetaFactor, s.weight.theta);
    V3 u{hn::Mul(s.q.x, s.inverse), hn::Mul(s.q.y, s.inverse), hn::Mul(s.q.z, s.inverse)};
    if constexpr (shaped) {
        const V along = hn::Mul(s.along, s.inverse);
        u = {hn::MulAdd(s.b.x, along, u.x), hn::MulAdd(s.b.y, along, u.y), hn::MulAdd(s.b.z, along, u.z)};
    }
    if constexpr (order >= 1) {
        const V slope = hn::Mul(s.weight.slope, s.inverse);
        unrolled<3>([&](auto k) { factor(SlopeFactor + k, hn::Mul(slope, at<k>(u))); });
        if constexpr (order >= 2)
            factor(PlainSlopeFactor, hn::Mul(slope, s.inverse));
    }
    if constexpr (order >= 2) {
        const V bend = hn::Mul(hn::Mul(s.weight.bend, s.inverse), s.inverse);
        const V plain = hn::Mul(hn::Mul(s.weight.slope, s.inverse), s.inverse);
        forPairs([&](auto k, auto l) {
            V value = hn::Mul(hn::Mul(bend, at<k>(u)), at<l>(u));
            if constexpr (shaped) // the part of M that PlainSlopeFactor does not know
                value = hn::NegMulAdd(plain, hn::Mul(at<k>(s.b), at<l>(s.b)), value);
            factor(BendFactor + sym(k, l), value);
        });
    }
    if constexpr (order >= 1)
        if (in.facing == Facing::Part)
            prepareParts<order>(*in.axis, s, u, place, dense);
    unrolled<3>([&](auto k) { monomial(NTerm + k, at<k>(s.n)); });
    monomial(HeightTerm, s.height);
    monomial(SquareTerm, s.square);
    if constexpr (outer != Outer::None) {
        const V3& y = outer == Outer::Normals ? s.n : s.q;
        forPairs([&](auto k, auto l) { monomial(OuterTerm + sym(k, l), hn::Mul(at<k>(y), at<l>(y))); });
    }
}

/// Factors times monomials, a factor at a time so that its accumulators fit into registers.
template <bool shaped, int order, Outer outer>
HWY_INLINE std::size_t sumProducts(const KernelInput& in, Dense& dense, std::size_t count, bool fresh,
                                   Rows<order, outer>& rows) {
    constexpr std::size_t monomials = monomialCount(outer);
    const D d;
    std::size_t samples = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        V unit = hn::Zero(d);
        for (std::size_t at = first; at < count; at += lanes) {
            const Lanes s = weigh<order, shaped>(in, dense, at, count);
            samples += hn::CountTrue(d, hn::Gt(s.weight.theta, hn::Zero(d)));
            accumulate(unit, s.weight.theta, s.unit);
            prepare<order, outer, shaped>(in, s, at, dense);
        }
        rows.put(sumCount(order, outer) - 1, first, unit, fresh);
        for (std::size_t f = 0; f < factorCount(order); ++f) {
            V acc[monomials];
            unrolled<monomials>([&](auto k) { acc[k] = hn::Zero(d); });
            for (std::size_t at = first; at < count; at += lanes) {
                const V factor = hn::Load(d, dense.factor[f] + at);
                acc[OneTerm] = hn::Add(acc[OneTerm], factor);
                unrolled<monomials - 1>(
                    [&](auto k) { accumulate(acc[k + 1], factor, hn::Load(d, dense.monomial[k + 1] + at)); });
            }
            unrolled<monomials>([&](auto k) { rows.put(k * factorCount(order) + f, first, acc[k], fresh); });
        }
    }
    return samples;
}

/// The first way.
template <Weight weight, bool shaped>
HWY_INLINE std::size_t sumClusters(const KernelInput& in, Rows<0, Outer::None>& rows) {
    const D d;
    const V3 x{constant(in.x[0]), constant(in.x[1]), constant(in.x[2])};
    std::size_t samples = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
        PlainSums sums;
        for (std::size_t c = 0; c < in.clusterCount; ++c) {
            const float* cluster = in.clusters[c] + first;
            const V3 p = load3(cluster, lanes);
            Lanes s;
            s.q = {hn::Sub(p.x, x.x), hn::Sub(p.y, x.y), hn::Sub(p.z, x.z)};
            s.n = load3(cluster + surfel::NormalX * lanes, lanes);
            s.h = hn::Mul(hn::Load(d, cluster + surfel::Support * lanes), constant(in.scale));
            s.square = dot(s.q, s.q);
            V metric = s.square;
            s.unit = s.h;
            if constexpr (shaped) {
                s.b = load3(cluster + in.shape * lanes, lanes);
                s.unit = shapedUnit(s.h, s.b);
                metric = shapedSquare(metric, dot(s.b, s.q));
            }
            const V r = hn::Mul(hn::Sqrt(metric), hn::Div(constant(1), s.h));
            s.weight = weightsAt<0>(r, weight, false);
            s.weight.theta = hn::IfThenElseZero(hn::Lt(metric, hn::Mul(s.h, s.h)), s.weight.theta);
            s.height = dot(s.n, s.q);
            samples += hn::CountTrue(d, hn::Gt(s.weight.theta, hn::Zero(d)));
            sums.add(s);
        }
        sums.put(first, true, rows);
    }
    return samples;
}

template <Weight weight, bool shaped>
int sumPlainly(const KernelInput& in, float* sums) {
    Rows<0, Outer::None> rows;
    const std::size_t samples = sumClusters<weight, shaped>(in, rows);
    reduce(rows, sums);
    return static_cast<int>(samples);
}

/// The second way. In parts of `capacity`, which leave the lanes as they are, being multiples of 16.
template <bool shaped, int order, Outer outer>
int sumAll(const KernelInput& in, float* sums) {
    Dense dense;
    Rows<order, outer> rows;
    bool fresh = true;
    std::size_t samples = 0, count = 0;
    for (std::size_t c = 0; c <= in.clusterCount; ++c) {
        if (c < in.clusterCount)
            count = pick<shaped>(in.clusters[c], in, count, dense);
        else
            pad<shaped>(count, dense);
        if (c < in.clusterCount && count < capacity)
            continue;
        const std::size_t part = std::min(count, capacity);
        if constexpr (order == 0 && outer == Outer::None)
            samples += sumPlain<shaped>(in, dense, part, fresh, rows);
        else
            samples += sumProducts<shaped, order, outer>(in, dense, part, fresh, rows);
        fresh = false;
        count -= part;
        for (int k = 0; k < HeightTerm && count > 0; ++k)
            std::copy_n(dense.monomial[k] + capacity, lanes, dense.monomial[k]);
        if constexpr (shaped)
            for (int k = 0; k < 3 && count > 0; ++k)
                std::copy_n(dense.shape[k] + capacity, lanes, dense.shape[k]);
    }
    reduce(rows, sums);
    return static_cast<int>(samples);
}

template <bool shaped, Outer outer>
int sumOfOrder(int order, const KernelInput& in, float* sums) {
    return order == 0   ? sumAll<shaped, 0, outer>(in, sums)
           : order == 1 ? sumAll<shaped, 1, outer>(in, sums)
                        : sumAll<shaped, 2, outer>(in, sums);
}

template <bool shaped>
int sumOfShape(int order, Outer outer, const KernelInput& in, float* sums) {
    if (order == 0 && outer == Outer::None && in.facing == Facing::All && !in.interpolating) {
        if (in.weight == Weight::Wendland)
            return sumPlainly<Weight::Wendland, shaped>(in, sums);
        if (in.weight == Weight::WendlandC4)
            return sumPlainly<Weight::WendlandC4, shaped>(in, sums);
    }
    switch (outer) {
    case Outer::None:
        return sumOfOrder<shaped, Outer::None>(order, in, sums);
    case Outer::Normals:
        return sumOfOrder<shaped, Outer::Normals>(order, in, sums);
    case Outer::Offsets:
        break;
    }
    return sumOfOrder<shaped, Outer::Offsets>(order, in, sums);
}

int sumDispatched(int order, Outer outer, const KernelInput& in, float* sums) {
    return in.shape > 0 ? sumOfShape<true>(order, outer, in, sums) : sumOfShape<false>(order, outer, in, sums);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(sumDispatched);

int sumKernel(int order, Outer outer, const KernelInput& in, float* sums) {
    return HWY_DYNAMIC_DISPATCH(sumDispatched)(order, outer, in, sums);
}

} // namespace surface
#endif
