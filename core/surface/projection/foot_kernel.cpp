// Picking, sums and steps of projections in lanes, compiled once per instruction set and chosen at run time (Google
// Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/projection/foot_kernel.cpp"
#include "core/base/instruction_sets.h"
#include "core/surface/projection/foot_lanes.h"

#include "core/surface/evaluation/sufficiency.h"
#include "core/surface/projection/foot_step.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Per instruction set, after the main header.
#include "core/surface/evaluation/kernels/kernel_weights.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

constexpr int inverseRow = surfel::Support + 1;
constexpr float steepEnough = 0.1f; ///< |grad f| of a surface
constexpr float shrinking = 0.9f;   ///< of the last step, that a step is shorter than

HWY_INLINE V3 operator+(const V3& a, const V3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE V3 operator-(const V3& a, const V3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE V3 operator*(const V3& a, V s) {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE V3 zero3() {
    return {hn::Zero(D()), hn::Zero(D()), hn::Zero(D())};
}
HWY_INLINE void accumulate(V3& sum, V factor, const V3& value) {
    accumulate(sum.x, factor, value.x), accumulate(sum.y, factor, value.y), accumulate(sum.z, factor, value.z);
}
HWY_INLINE void store3(const V3& v, float (*to)[NearLanes::lanes], std::size_t first) {
    const D d;
    hn::Store(v.x, d, to[0] + first), hn::Store(v.y, d, to[1] + first), hn::Store(v.z, d, to[2] + first);
}
HWY_INLINE unsigned bitsOf(M mask, std::size_t first) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask, bytes);
    const unsigned used = (1u << hn::Lanes(D())) - 1;
    return ((bytes[0] | static_cast<unsigned>(bytes[1]) << 8) & used) << first;
}

// --- picking

bool pickDispatched(ClusterSpan clusters, const base::Vec3f& x, float scale, float slack, std::size_t lane,
                    NearLanes& out) {
    const D d;
    const float place[3] = {x.x, x.y, x.z};
    std::size_t count = 0;
    for (const float* cluster : clusters)
        for (std::size_t first = 0; first < lanes; first += hn::Lanes(d)) {
            const float* c = cluster + first;
            const V3 p = load3(c, lanes), q = minus(p, place);
            const V h = hn::Mul(hn::Load(d, c + surfel::Support * lanes), constant(scale));
            const V reach = hn::MulAdd(h, constant(queryReach(1)), constant(slack));
            const M keep = hn::Lt(dot(q, q), hn::Mul(reach, reach));
            if (hn::AllFalse(d, keep))
                continue;
            const V3 n = load3(c + surfel::NormalX * lanes, lanes);
            const Packing packing(keep);
            const auto append = [&](int row, V value) {
                hn::StoreU(packing.pack(value), d, out.picked[lane][row] + count);
            };
            append(surfel::X, p.x), append(surfel::Y, p.y), append(surfel::Z, p.z);
            append(surfel::NormalX, n.x), append(surfel::NormalY, n.y), append(surfel::NormalZ, n.z);
            append(surfel::Support, h), append(inverseRow, hn::Div(constant(1), h));
            count += hn::CountTrue(d, keep);
            if (count > NearLanes::capacity)
                return false;
        }
    out.counts[lane] = count;
    return true;
}

// --- value and gradient, the formulas of self_kernel.cpp and the derivative of n beside them

/// A near surfel of each lane.
struct Near {
    V3 y, n;
    V h, inverse;

    HWY_INLINE Near(const NearLanes& near, std::size_t k, std::size_t first, const V3& x) {
        const float* s = near.turned[k][0] + first;
        y = x - load3(s, lanes);
        n = load3(s + surfel::NormalX * lanes, lanes);
        h = hn::Load(D(), s + surfel::Support * lanes);
        inverse = hn::Load(D(), s + inverseRow * lanes);
    }
};

struct FootSums {
    V one, height, square, unit, samples;
    V3 y, n;

    /// Keeps the slopes of the weights for the second pass.
    template <Weight weight>
    HWY_INLINE void sum(const NearLanes& near, std::size_t first, const V3& x, float* slopes) {
        const D d;
        one = height = square = unit = samples = hn::Zero(d);
        y = n = zero3();
        for (std::size_t k = 0; k < near.count; ++k) {
            const Near s(near, k, first, x);
            const V squareY = dot(s.y, s.y), r = hn::Mul(hn::Sqrt(squareY), s.inverse);
            WeightLanes w = weightsAt<1>(r, weight, false);
            if constexpr (weight == Weight::Gaussian) {
                const M inside = hn::Lt(r, constant(1));
                w.theta = hn::IfThenElseZero(inside, w.theta);
                w.slope = hn::IfThenElseZero(inside, w.slope);
            }
            hn::Store(hn::Mul(hn::Mul(w.slope, s.inverse), s.inverse), d, slopes + k * lanes + first);
            samples = hn::Add(samples, hn::IfThenElseZero(hn::Gt(w.theta, hn::Zero(d)), constant(1)));
            one = hn::Add(one, w.theta);
            accumulate(y, w.theta, s.y), accumulate(n, w.theta, s.n);
            accumulate(height, w.theta, dot(s.n, s.y));
            accumulate(square, w.theta, squareY);
            accumulate(unit, w.theta, s.h);
        }
        if (weight == Weight::Gaussian)
            unit = hn::Mul(unit, constant(1 / gaussianReach));
    }
};

/// An iterate and what is known there.
struct Here {
    V3 away, n, g; ///< x - c, normal, gradient
    V3 turn[3];    ///< rows of grad n
    V value, unit;
    M usual;

    HWY_INLINE V3 turned(const V3& v) const { return {dot(turn[0], v), dot(turn[1], v), dot(turn[2], v)}; }
};

HWY_INLINE void storeValues(const FootSums& s, const Here& here, V agreement, const V3& x, std::size_t first,
                            FootLanes& out) {
    const D d;
    hn::Store(s.samples, d, out.samples + first);
    hn::Store(s.one, d, out.weight + first);
    hn::Store(here.value, d, out.value + first);
    hn::Store(here.unit, d, out.unit + first);
    hn::Store(agreement, d, out.agreement + first);
    hn::Store(hn::Sqrt(dot(here.away, here.away)), d, out.offCentre + first);
    store3(x - here.away, out.centroid, first);
    store3(here.n, out.normal, first);
    store3(here.g, out.gradient, first);
    for (int a = 0; a < 3; ++a)
        store3(here.turn[a], out.normalGradient + 3 * a, first);
}

template <Weight weight>
HWY_INLINE Here evaluate(const FootOptions& options, const NearLanes& near, const V3& x, std::size_t first,
                         float* slopes, FootLanes& out) {
    FootSums s;
    s.sum<weight>(near, first, x, slopes);
    Here here;
    const V inverseWeight = hn::Div(constant(1), s.one), length = hn::Sqrt(dot(s.n, s.n));
    const V inverseLength = hn::Div(constant(1), length), agreement = hn::Mul(length, inverseWeight);
    const V mu = constant(options.mu), flat = constant(1 - options.mu);
    here.away = s.y * inverseWeight;
    here.n = s.n * inverseLength;
    here.unit = hn::Mul(s.unit, inverseWeight);
    const V height = dot(here.n, here.away);
    here.value = hn::MulAdd(hn::Mul(s.height, inverseWeight), mu, hn::Mul(height, flat));

    const V square = hn::Mul(s.square, inverseWeight), spread = hn::Sub(square, dot(here.away, here.away));
    const V least = hn::Mul(constant(options.leastSpread), hn::Max(square, hn::Mul(here.unit, here.unit)));
    here.usual = hn::And(hn::And(hn::Gt(s.one, constant(leastWeight<float>)),
                                 hn::Ge(s.samples, constant(static_cast<float>(leastSamples)))),
                         hn::And(hn::Ge(agreement, constant(options.leastAgreement)), hn::Gt(spread, least)));

    // grad f as in self_kernel.cpp: one sum of slopes a_i times g_i; grad m is - sum a_i n_i y_i^T
    const V symmetric = hn::Mul(mu, inverseWeight);
    const V3 across = here.n * hn::Mul(flat, inverseWeight);
    const V3 v = (here.away - here.n * height) * hn::Mul(flat, inverseLength);
    const V same = hn::MulAdd(hn::Mul(s.height, inverseWeight), symmetric, dot(across, here.away));
    V3 sum = zero3(), mx = zero3(), my = zero3(), mz = zero3();
    for (std::size_t k = 0; k < near.count; ++k) {
        const Near one(near, k, first, x);
        const V a = hn::Load(D(), slopes + k * lanes + first);
        V3 along = v;
        accumulate(along, symmetric, one.y);
        const V g = hn::Add(hn::Sub(dot(across, one.y), same), dot(one.n, along));
        const V3 slope = one.y * a;
        accumulate(sum, g, slope);
        accumulate(mx, one.n.x, slope), accumulate(my, one.n.y, slope), accumulate(mz, one.n.z, slope);
    }
    here.g = here.n * flat + s.n * symmetric - sum;
    // grad n = (n n^T - 1) sum / |m|
    const V3 normal = mx * here.n.x + my * here.n.y + mz * here.n.z;
    here.turn[0] = (normal * here.n.x - mx) * inverseLength;
    here.turn[1] = (normal * here.n.y - my) * inverseLength;
    here.turn[2] = (normal * here.n.z - mz) * inverseLength;
    storeValues(s, here, agreement, x, first, out);
    return here;
}

// --- the step of foot_step.h, W^-1 by its series

HWY_INLINE V largestPart(const V3& v) {
    return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

HWY_INLINE void step(const FootOptions& options, const Here& here, const V3& x, std::size_t first, FootLanes& io) {
    const D d;
    const V3 back =
        V3{hn::Load(d, io.from[0] + first), hn::Load(d, io.from[1] + first), hn::Load(d, io.from[2] + first)} - x;
    const V squareG = dot(here.g, here.g), inverse = hn::Div(constant(1), squareG);
    const V parts = hn::Mul(hn::Add(here.value, dot(here.g, back)), inverse);
    const V s = hn::Mul(parts, hn::Sqrt(squareG));
    const auto tangential = [&](const V3& v) { return v - here.g * hn::Mul(dot(here.g, v), inverse); };
    const V3 r = back - here.g * parts, t = tangential(r);
    const V3 once = tangential(here.turned(t)) * s, twice = tangential(here.turned(once)) * s;
    const V3 p = t - once + twice, way = r - t + p;
    const V size = hn::Sqrt(dot(way, way));
    store3(x + way, io.to, first);
    hn::Store(size, d, io.size + first);

    const V bend =
        hn::Mul(hn::Mul(s, s), hn::Add(hn::Add(dot(here.turn[0], here.turn[0]), dot(here.turn[1], here.turn[1])),
                                       dot(here.turn[2], here.turn[2])));
    const V reach = hn::Mul(constant(static_cast<float>(longestStep)), here.unit);
    constexpr float bendLimit = static_cast<float>(smallBend * smallBend);
    const M known = hn::And(hn::And(here.usual, hn::Gt(squareG, constant(steepEnough * steepEnough))),
                            hn::And(hn::Le(bend, constant(bendLimit)), hn::Le(dot(p, p), hn::Mul(reach, reach))));
    const M fades = hn::And(hn::Gt(hn::Abs(here.value), hn::Mul(constant(static_cast<float>(fadesFrom)), here.unit)),
                            hn::Lt(dot(here.g, here.n), constant(static_cast<float>(fadesBelow))));
    const M shrinks = hn::Lt(size, hn::Mul(constant(shrinking), hn::Load(d, io.lastSize + first)));
    const V places = hn::MulAdd(constant(4), hn::Sqrt(dot(back, back)), largestPart(x));
    const V smallest = hn::Max(hn::Mul(constant(options.tolerance), here.unit),
                               hn::Mul(constant(std::numeric_limits<float>::epsilon()), places));
    io.usual |= bitsOf(here.usual, first);
    io.settled |= bitsOf(hn::And(known, hn::Le(size, smallest)), first);
    io.onZero |= bitsOf(hn::Le(hn::Abs(here.value), hn::Mul(constant(10), smallest)), first);
    io.leads |= bitsOf(hn::And(hn::AndNot(fades, known), shrinks), first);
}

template <Weight weight>
void footOfWeight(const FootOptions& options, const NearLanes& near, FootLanes& io) {
    HWY_ALIGN float slopes[NearLanes::capacity * NearLanes::lanes];
    io.usual = io.settled = io.onZero = io.leads = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D())) {
        const V3 x = load3(io.at[0] + first, lanes);
        step(options, evaluate<weight>(options, near, x, first, slopes, io), x, first, io);
    }
}

void footDispatched(const FootOptions& options, const NearLanes& near, FootLanes& io) {
    switch (options.weight) {
    case Weight::Wendland:
        return footOfWeight<Weight::Wendland>(options, near, io);
    case Weight::WendlandC4:
        return footOfWeight<Weight::WendlandC4>(options, near, io);
    case Weight::Gaussian:
        break;
    }
    footOfWeight<Weight::Gaussian>(options, near, io);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(pickDispatched);
HWY_EXPORT(footDispatched);

bool pickNear(ClusterSpan clusters, const base::Vec3f& x, float scale, float slack, std::size_t lane, NearLanes& out) {
    return HWY_DYNAMIC_DISPATCH(pickDispatched)(clusters, x, scale, slack, lane, out);
}
void footKernel(const FootOptions& options, const NearLanes& near, FootLanes& io) {
    HWY_DYNAMIC_DISPATCH(footDispatched)(options, near, io);
}

} // namespace surface
#endif
