// The free-space test, compiled once per instruction set and chosen at run time (Google Highway). As in self-evaluation
// the surfels of a cluster are the lanes, and those around them are visited one by one.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/evaluation/kernels/free_space_kernel.cpp"
#include "core/surface/evaluation/kernels/free_space_kernel.h"
#include "core/base/instruction_sets.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// Per instruction set, after the main header.
#include "core/surface/evaluation/kernels/kernel_pick.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

/// Rows are the coordinates of places and normals.
using Bystanders = Picked<freeSpaceRows>;

HWY_INLINE Bystanders pickBystanders(const FreeSpaceInput& in, float* scratch) {
    const BoxLanes box(in.box);
    const float reach = queryReach(in.query.ring + in.query.clear);
    return pickFrom<freeSpaceRows>(in.around, scratch, [&](const float* c, const auto& append) {
        const V3 p = load3(c, lanes), n = load3(c + surfel::NormalX * lanes, lanes);
        append(hn::Lt(box.distanceSq(p), constant(reach * reach)), p.x, p.y, p.z, n.x, n.y, n.z);
    });
}

/// base::perpendicular of unit normals, times `length`, and its cross product with them.
struct Tangents {
    V3 u, v;

    HWY_INLINE Tangents(const V3& n, float length) {
        const V sign = hn::CopySign(constant(1), n.z), l = constant(length);
        const V a = hn::Div(constant(-1), hn::Add(sign, n.z));
        const V sa = hn::Mul(sign, a);
        const V3 t{hn::MulAdd(hn::Mul(sa, n.x), n.x, constant(1)), hn::Mul(hn::Mul(sa, n.x), n.y),
                   hn::Neg(hn::Mul(sign, n.x))};
        u = {hn::Mul(t.x, l), hn::Mul(t.y, l), hn::Mul(t.z, l)};
        v = {hn::Sub(hn::Mul(n.y, u.z), hn::Mul(n.z, u.y)), hn::Sub(hn::Mul(n.z, u.x), hn::Mul(n.x, u.z)),
             hn::Sub(hn::Mul(n.x, u.y), hn::Mul(n.y, u.x))};
    }
};

/// Normals of unit length; z where there is none.
HWY_INLINE V3 unitNormals(const V3& n) {
    const V sq = dot(n, n);
    const M known = hn::Gt(sq, constant(1e-12f));
    const V scale = hn::Div(constant(1), hn::Sqrt(hn::IfThenElse(known, sq, constant(1))));
    return {hn::IfThenElseZero(known, hn::Mul(n.x, scale)), hn::IfThenElseZero(known, hn::Mul(n.y, scale)),
            hn::IfThenElse(known, hn::Mul(n.z, scale), constant(1))};
}

/// With y from the surfel to another, e one of eight unit directions and R the ring, |y - R e|^2 = |y|^2 - 2 R e.y +
/// R^2: the direction is free where no |y|^2 - 2 R e.y is below clear^2 - R^2. Tangents come times 2 R.
struct Ring {
    V east, northEast, north, northWest, west, southWest, south, southEast;

    HWY_INLINE Ring() { east = northEast = north = northWest = west = southWest = south = southEast = constant(1e30f); }
    HWY_INLINE void see(V square, V a, V b) {
        const V diagonal = constant(0.70710678f);
        const V d = hn::Mul(hn::Add(a, b), diagonal), e = hn::Mul(hn::Sub(b, a), diagonal);
        east = hn::Min(east, hn::Sub(square, a)), west = hn::Min(west, hn::Add(square, a));
        north = hn::Min(north, hn::Sub(square, b)), south = hn::Min(south, hn::Add(square, b));
        northEast = hn::Min(northEast, hn::Sub(square, d)), southWest = hn::Min(southWest, hn::Add(square, d));
        northWest = hn::Min(northWest, hn::Sub(square, e)), southEast = hn::Min(southEast, hn::Add(square, e));
    }
    HWY_INLINE V widest() const {
        return hn::Max(hn::Max(hn::Max(east, west), hn::Max(north, south)),
                       hn::Max(hn::Max(northEast, southWest), hn::Max(northWest, southEast)));
    }
};

template <FreeSpaceQuery::Sheets sheets>
HWY_INLINE unsigned lookFrom(const FreeSpaceInput& in, const Bystanders& around, std::size_t first) {
    const D d;
    const FreeSpaceQuery& q = in.query;
    const V3 x = load3(in.cluster + first, lanes), n = load3(in.cluster + first + surfel::NormalX * lanes, lanes);
    const Tangents t(unitNormals(n), 2 * q.ring);
    const V closeSq = constant(q.close * q.close), leastCosine = constant(q.leastCosine), far = constant(1e30f);
    Ring ring;
    V close = hn::Zero(d); // it is close to itself
    for (std::size_t i = 0; i < around.count; ++i) {
        const auto channel = [&](std::size_t k) { return constant(around.row[k][i]); };
        const V3 y{hn::Sub(channel(0), x.x), hn::Sub(channel(1), x.y), hn::Sub(channel(2), x.z)};
        V square = dot(y, y);
        if constexpr (sheets != FreeSpaceQuery::Sheets::All) {
            const V cosine = dot(n, V3{channel(3), channel(4), channel(5)});
            const bool anySign = sheets == FreeSpaceQuery::Sheets::Unsigned;
            square = hn::IfThenElse(hn::Gt(anySign ? hn::Abs(cosine) : cosine, leastCosine), square, far);
        }
        close = hn::Add(close, hn::IfThenElseZero(hn::Lt(square, closeSq), constant(1)));
        ring.see(square, dot(y, t.u), dot(y, t.v));
    }
    const M free = hn::Ge(ring.widest(), constant(q.clear * q.clear - q.ring * q.ring));
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Or(free, hn::Gt(close, constant(1.5f))), bytes);
    return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
}

template <FreeSpaceQuery::Sheets sheets>
unsigned lookAll(const FreeSpaceInput& in, float* scratch) {
    const Bystanders around = pickBystanders(in, scratch);
    unsigned out = 0;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(D()))
        out |= lookFrom<sheets>(in, around, first) << first;
    return out;
}

unsigned freeSpaceDispatched(const FreeSpaceInput& in, float* scratch) {
    switch (in.query.sheets) {
    case FreeSpaceQuery::Sheets::All:
        return lookAll<FreeSpaceQuery::Sheets::All>(in, scratch);
    case FreeSpaceQuery::Sheets::Unsigned:
        return lookAll<FreeSpaceQuery::Sheets::Unsigned>(in, scratch);
    case FreeSpaceQuery::Sheets::Signed:
        break;
    }
    return lookAll<FreeSpaceQuery::Sheets::Signed>(in, scratch);
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(freeSpaceDispatched);

unsigned freeSpaceKernel(const FreeSpaceInput& in, float* scratch) {
    return HWY_DYNAMIC_DISPATCH(freeSpaceDispatched)(in, scratch);
}

} // namespace surface
#endif
