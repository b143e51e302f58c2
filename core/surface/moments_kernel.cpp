// The hot loop, compiled once per instruction set and chosen at run time (Google Highway).
//
// 16 virtual lanes: lane i of every cluster goes to lane i of the accumulators, whatever the width of the registers; on
// narrower ones the lanes are done in groups. Multiply-adds are explicit, roots and quotients exact, the reduction
// fixed, so that AVX2 and AVX-512 give the same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/moments_kernel.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "core/surface/candidates.h"
#include "core/surface/moments_float.h"
#include "core/surfel/surfel_block.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// The exponential comes after the main header.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, surfel::clusterSize>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr int lanes = surfel::clusterSize;

struct Weighted {
    V theta, a; ///< weight, and its gradient over q
};

/// Wendland C2 with t = max(0, 1 - r): theta = t^4 (5 - 4t), a = 20 t^3 / h^2.
HWY_INLINE Weighted wendlandWeight(D d, V distanceSq, V h, M keep) {
    const V inverse = hn::Div(hn::Set(d, 1.0f), h);
    const V r = hn::Mul(hn::Sqrt(distanceSq), inverse);
    const V t = hn::IfThenElseZero(keep, hn::Max(hn::Zero(d), hn::Sub(hn::Set(d, 1.0f), r)));
    const V t2 = hn::Mul(t, t), t3 = hn::Mul(t2, t);
    const V theta = hn::Mul(hn::Mul(t2, t2), hn::NegMulAdd(hn::Set(d, 4.0f), t, hn::Set(d, 5.0f)));
    const V a = hn::Mul(hn::Mul(hn::Set(d, 20.0f), t3), hn::Mul(inverse, inverse));
    return {theta, a};
}

/// exp(-s^2/H^2), cut at the support h = H gaussianReach: a = 2 theta / H^2.
HWY_INLINE Weighted gaussianWeight(D d, V distanceSq, V h, M keep) {
    const V inverse = hn::Div(hn::Set(d, gaussianReach), h);
    const V inverseSq = hn::Mul(inverse, inverse);
    const V exponent = hn::Max(hn::Neg(hn::Mul(distanceSq, inverseSq)), hn::Set(d, -40.0f));
    const M inside = hn::And(keep, hn::Lt(distanceSq, hn::Mul(h, h)));
    const V theta = hn::IfThenElseZero(inside, hn::Exp(d, exponent));
    return {theta, hn::Mul(hn::Add(theta, theta), inverseSq)};
}

HWY_INLINE void accumulate(V& sum, V factor, V value) {
    sum = hn::MulAdd(factor, value, sum);
}

template <int order, Outer outer>
HWY_INLINE void addOuter(V theta, V a, const V (&q)[3], const V (&n)[3], V* sums) {
    if constexpr (outer == Outer::Normals) {
        for (int k = 0; k < 3; ++k) {
            const V tn = hn::Mul(theta, n[k]);
            for (int l = k; l < 3; ++l)
                accumulate(sums[sym(k, l)], tn, n[l]);
        }
        if constexpr (order >= 1)
            for (int j = 0; j < 3; ++j) {
                const V aq = hn::Mul(a, q[j]);
                for (int k = 0; k < 3; ++k)
                    for (int l = k; l < 3; ++l)
                        accumulate(sums[6 + 3 * sym(k, l) + j], hn::Mul(aq, n[k]), n[l]);
            }
    }
    if constexpr (outer == Outer::Offsets) {
        for (int k = 0; k < 3; ++k) {
            const V tq = hn::Mul(theta, q[k]);
            for (int l = k; l < 3; ++l)
                accumulate(sums[sym(k, l)], tq, q[l]);
        }
        if constexpr (order >= 1)
            for (int j = 0; j < 3; ++j) {
                const V aq = hn::Mul(a, q[j]);
                for (int k = j; k < 3; ++k)
                    for (int l = k; l < 3; ++l)
                        accumulate(sums[6 + sym3(j, k, l)], hn::Mul(aq, q[k]), q[l]);
            }
    }
}

/// Adds one group of lanes of one cluster; returns how many have weight.
template <int order, Outer outer>
HWY_INLINE std::size_t addCluster(D d, const float* c, const KernelInput& in, V* sums) {
    const V q[3] = {hn::Sub(hn::Load(d, c), hn::Set(d, in.x[0])), hn::Sub(hn::Load(d, c + lanes), hn::Set(d, in.x[1])),
                    hn::Sub(hn::Load(d, c + 2 * lanes), hn::Set(d, in.x[2]))};
    V n[3] = {hn::Load(d, c + surfel::NormalX * lanes), hn::Load(d, c + surfel::NormalY * lanes),
              hn::Load(d, c + surfel::NormalZ * lanes)};
    const V h = hn::Load(d, c + surfel::Support * lanes);
    const V distanceSq = hn::MulAdd(q[2], q[2], hn::MulAdd(q[1], q[1], hn::Mul(q[0], q[0])));
    M keep = hn::Lt(distanceSq, hn::Mul(h, h));
    if (in.facing != Facing::All) {
        const V facing =
            hn::MulAdd(n[2], hn::Set(d, in.reference[2]),
                       hn::MulAdd(n[1], hn::Set(d, in.reference[1]), hn::Mul(n[0], hn::Set(d, in.reference[0]))));
        if (in.facing == Facing::Skip)
            keep = hn::And(keep, hn::Gt(facing, hn::Set(d, facingLimit)));
        else
            for (V& each : n)
                each = hn::Xor(each, hn::And(facing, hn::SignBit(d)));
    }
    const auto [theta, a] =
        in.weight == Weight::Gaussian ? gaussianWeight(d, distanceSq, h, keep) : wendlandWeight(d, distanceSq, h, keep);
    const V height = hn::MulAdd(n[2], q[2], hn::MulAdd(n[1], q[1], hn::Mul(n[0], q[0])));
    sums[0] = hn::Add(sums[0], theta);
    for (int k = 0; k < 3; ++k) {
        accumulate(sums[1 + k], theta, q[k]);
        accumulate(sums[4 + k], theta, n[k]);
    }
    accumulate(sums[7], theta, height);
    accumulate(sums[8], theta, h);
    if constexpr (order >= 1) {
        for (int k = 0; k < 3; ++k) {
            const V aq = hn::Mul(a, q[k]);
            sums[9 + k] = hn::Add(sums[9 + k], aq);
            for (int l = 0; l < 3; ++l) {
                if (l >= k)
                    accumulate(sums[12 + sym(k, l)], aq, q[l]);
                accumulate(sums[18 + 3 * l + k], aq, n[l]);
            }
            accumulate(sums[27 + k], aq, height);
        }
    }
    addOuter<order, outer>(theta, a, q, n, sums + (order == 0 ? sumsOfOrder0 : sumsOfOrder1));
    return hn::CountTrue(d, hn::Gt(theta, hn::Zero(d)));
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

template <int order, Outer outer>
int sumAll(const KernelInput& in, float* sums) {
    constexpr int count = sumCount(order, outer), padded = (count + 3) / 4 * 4;
    const D d;
    const int width = static_cast<int>(hn::Lanes(d));
    HWY_ALIGN float rows[padded * lanes];
    std::size_t samples = 0;
    for (int first = 0; first < lanes; first += width) {
        V acc[padded];
        for (V& each : acc)
            each = hn::Zero(d);
        for (std::size_t c = 0; c < in.clusterCount; ++c)
            samples += addCluster<order, outer>(d, in.clusters[c] + first, in, acc);
        for (int k = 0; k < padded; ++k)
            hn::Store(acc[k], d, rows + k * lanes + first);
    }
    for (int k = 0; k < padded; k += 4)
        reduceFour(rows + k * lanes, sums + k);
    return static_cast<int>(samples);
}

int sumDispatched(int order, Outer outer, const KernelInput& in, float* sums) {
    switch (outer) {
    case Outer::None:
        return order == 0 ? sumAll<0, Outer::None>(in, sums) : sumAll<1, Outer::None>(in, sums);
    case Outer::Normals:
        return order == 0 ? sumAll<0, Outer::Normals>(in, sums) : sumAll<1, Outer::Normals>(in, sums);
    case Outer::Offsets:
        break;
    }
    return order == 0 ? sumAll<0, Outer::Offsets>(in, sums) : sumAll<1, Outer::Offsets>(in, sums);
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
