#include "core/render/splats/splat_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/splats/splat_kernels.cpp"
#include "core/base/instruction_sets.h"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using surfel::clusterSize;

/// A cluster's splats as arrays, before those outside the tile are dropped.
struct ClusterSplats {
    HWY_ALIGN float x[clusterSize], y[clusterSize], z[clusterSize], gradX[clusterSize], gradY[clusterSize];
    HWY_ALIGN float radius[clusterSize], back[clusterSize], rise[clusterSize];
    HWY_ALIGN float normalX[clusterSize], normalY[clusterSize], normalZ[clusterSize];
    HWY_ALIGN float shapeX[clusterSize], shapeY[clusterSize], shapeZ[clusterSize], mean[clusterSize];
    /// First and last pixel of the tile, as whole numbers; empty where hidden.
    HWY_ALIGN float left[clusterSize], right[clusterSize], top[clusterSize], bottom[clusterSize];
};

template <class D, class V>
HWY_INLINE V along(D d, const base::Vec3f& axis, V x, V y, V z) {
    return hn::MulAdd(hn::Set(d, axis.z), z, hn::MulAdd(hn::Set(d, axis.y), y, hn::Mul(hn::Set(d, axis.x), x)));
}

/// Pixels of the tile whose slopes lie within `half` of `centre`.
template <class D, class V>
HWY_INLINE void pixels(D d, V centre, V half, float first, float focalPx, int count, float* low, float* high) {
    const V a = hn::Mul(hn::Sub(hn::Sub(centre, half), hn::Set(d, first)), hn::Set(d, focalPx));
    const V b = hn::Mul(hn::Sub(hn::Add(centre, half), hn::Set(d, first)), hn::Set(d, focalPx));
    hn::Store(hn::Ceil(hn::Max(a, hn::Zero(d))), d, low);
    hn::Store(hn::Floor(hn::Min(b, hn::Set(d, static_cast<float>(count - 1)))), d, high);
}

template <bool shaped>
HWY_INLINE void transform(const surfel::SurfelBlock& block, int cluster, const ViewFrame& view, const SplatStyle& style,
                          const TileArea& area, ClusterSplats& out) {
    const HWY_CAPPED(float, clusterSize) d;
    const auto load = [&](int channel, int lane)
                          HWY_ATTR { return hn::Load(d, block.channel(cluster, channel) + lane); };
    const auto one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const float x0 = view.slopeX(area.left), y0 = view.slopeY(area.top);
    const bool parallel = view.parallel;
    for (int lane = 0; lane < clusterSize; lane += static_cast<int>(hn::Lanes(d))) {
        const auto wx = hn::Sub(load(surfel::X, lane), hn::Set(d, view.eye.x));
        const auto wy = hn::Sub(load(surfel::Y, lane), hn::Set(d, view.eye.y));
        const auto wz = hn::Sub(load(surfel::Z, lane), hn::Set(d, view.eye.z));
        const auto px = hn::Sub(along(d, view.right, wx, wy, wz), hn::Set(d, view.rest.x));
        const auto py = hn::Sub(along(d, view.down, wx, wy, wz), hn::Set(d, view.rest.y));
        const auto pz = hn::Sub(along(d, view.forward, wx, wy, wz), hn::Set(d, view.rest.z));
        const auto mx = load(surfel::NormalX, lane), my = load(surfel::NormalY, lane), mz = load(surfel::NormalZ, lane);
        auto nx = along(d, view.right, mx, my, mz), ny = along(d, view.down, mx, my, mz),
             nz = along(d, view.forward, mx, my, mz);
        // The ray to the centre, and its length. An unknown normal faces the eye.
        const auto rx = parallel ? zero : px, ry = parallel ? zero : py, rz = parallel ? one : pz;
        const auto distance = hn::Sqrt(hn::MulAdd(rx, rx, hn::MulAdd(ry, ry, hn::Mul(rz, rz))));
        const auto unknown = hn::Lt(hn::MulAdd(nx, nx, hn::MulAdd(ny, ny, hn::Mul(nz, nz))), hn::Set(d, 0.25f));
        const auto toEye = hn::Div(hn::Set(d, -1.0f), distance);
        nx = hn::IfThenElse(unknown, hn::Mul(rx, toEye), nx);
        ny = hn::IfThenElse(unknown, hn::Mul(ry, toEye), ny);
        nz = hn::IfThenElse(unknown, hn::Mul(rz, toEye), nz);
        auto np = hn::MulAdd(nx, rx, hn::MulAdd(ny, ry, hn::Mul(nz, rz)));
        const auto away = hn::Gt(np, zero);
        if (!style.oriented) {
            nx = hn::IfThenElse(away, hn::Neg(nx), nx);
            ny = hn::IfThenElse(away, hn::Neg(ny), ny);
            nz = hn::IfThenElse(away, hn::Neg(nz), nz);
            np = hn::IfThenElse(away, hn::Neg(np), np);
        }
        const auto least = hn::Mul(hn::Set(d, minCosine), distance);
        const auto steep = hn::CopySign(hn::Max(hn::Abs(np), least), np);
        const auto radius = hn::Mul(load(surfel::Support, lane), hn::Set(d, style.radiusOfSupport));
        const auto inverseZ = parallel ? one : hn::Div(one, pz), x = hn::Mul(px, inverseZ), y = hn::Mul(py, inverseZ);
        // Of an ellipse b in its plane, as a unit vector times what the short way lacks of the long one, and the radius
        // of a disc of the same area.
        auto sx = zero, sy = zero, sz = zero;
        if constexpr (shaped) {
            const auto ox = load(style.shape, lane), oy = load(style.shape + 1, lane), oz = load(style.shape + 2, lane);
            const auto bx = along(d, view.right, ox, oy, oz), by = along(d, view.down, ox, oy, oz),
                       bz = along(d, view.forward, ox, oy, oz);
            const auto off = hn::MulAdd(nx, bx, hn::MulAdd(ny, by, hn::Mul(nz, bz)));
            sx = hn::NegMulAdd(off, nx, bx), sy = hn::NegMulAdd(off, ny, by), sz = hn::NegMulAdd(off, nz, bz);
            hn::Store(sx, d, out.shapeX + lane);
            hn::Store(sy, d, out.shapeY + lane);
            hn::Store(sz, d, out.shapeZ + lane);
            const auto aspect = hn::Sqrt(hn::MulAdd(sx, sx, hn::MulAdd(sy, sy, hn::MulAdd(sz, sz, one))));
            hn::Store(hn::Div(radius, hn::Sqrt(aspect)), d, out.mean + lane);
            const auto lacks = hn::Div(one, aspect);
            sx = hn::Mul(sx, lacks), sy = hn::Mul(sy, lacks), sz = hn::Mul(sz, lacks);
        }
        // Half sizes of the disc along the axes; then as in screenBounds.
        const auto extent = [&](auto n, auto s) HWY_ATTR {
            auto left = hn::NegMulAdd(n, n, one);
            if constexpr (shaped)
                left = hn::NegMulAdd(s, s, left);
            return hn::Mul(radius, hn::Sqrt(hn::Max(zero, left)));
        };
        const auto ez = extent(nz, sz), nearest = hn::Sub(pz, ez);
        const auto behind = hn::Le(pz, hn::Mul(radius, hn::Set(d, 1.02f)));
        const auto filter = hn::Set(d, filterPx * view.step);
        const auto half = [&](auto e, auto slope) HWY_ATTR {
            return hn::Max(filter, parallel ? e : hn::Div(hn::MulAdd(hn::Abs(slope), ez, e), nearest));
        };
        pixels(d, x, half(extent(nx, sx), x), x0, view.focalPx, area.width, out.left + lane, out.right + lane);
        pixels(d, y, half(extent(ny, sy), y), y0, view.focalPx, area.height, out.top + lane, out.bottom + lane);
        hn::Store(hn::IfThenElse(behind, hn::Set(d, -1.0f), hn::Load(d, out.right + lane)), d, out.right + lane);
        hn::Store(x, d, out.x + lane);
        hn::Store(y, d, out.y + lane);
        hn::Store(pz, d, out.z + lane);
        hn::Store(hn::Div(nx, steep), d, out.gradX + lane);
        hn::Store(hn::Div(ny, steep), d, out.gradY + lane);
        hn::Store(radius, d, out.radius + lane);
        hn::Store(hn::IfThenElse(away, hn::Div(np, distance), zero), d, out.back + lane);
        hn::Store(ez, d, out.rise + lane);
        hn::Store(nx, d, out.normalX + lane);
        hn::Store(ny, d, out.normalY + lane);
        hn::Store(nz, d, out.normalZ + lane);
    }
}

int gather(const BinEntry& entry, const ViewFrame& view, const SplatStyle& style, const TileArea& area, Splat* out) {
    int count = 0;
    ClusterSplats s;
    const surfel::Colour* shown = style.table ? style.table->of(entry.block) : nullptr;
    const bool shaped = style.shape > 0 && entry.block->extraWords() > 0; // what stands for many is round
    for (std::uint32_t left = entry.clusters; left; left &= left - 1) {
        const int cluster = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(left));
        if (shaped)
            transform<true>(*entry.block, cluster, view, style, area, s);
        else
            transform<false>(*entry.block, cluster, view, style, area, s);
        const float* mask = entry.block->channel(cluster, surfel::Mask);
        const std::uint32_t* colour = entry.block->words(cluster, surfel::ColourWord);
        const int lanes = std::min(clusterSize, entry.block->size() - cluster * clusterSize);
        for (int i = 0; i < lanes; ++i) {
            if (!(s.left[i] <= s.right[i] && s.top[i] <= s.bottom[i]))
                continue;
            const CutCode code =
                entry.cuts ? (*entry.cuts)[static_cast<std::size_t>(cluster * clusterSize + i)] : wholeDisc;
            const int slot = cluster * clusterSize + i;
            const DiscCut cut =
                code == wholeDisc ? DiscCut{} : discCut(entry.block->normal(slot), entry.block->support(slot), code);
            if (!(cut.radius > 0))
                continue;
            const float radius = cut.radius * s.radius[i], z = s.z[i];
            const bool behind = style.oriented && s.back[i] > 0;
            const float mean = shaped ? cut.radius * s.mean[i] : radius;
            const float filter = filterPx * view.pixelSize(z), range = radius + filterDepth * filter;
            const auto edge = [&](const CutLine& line) HWY_ATTR {
                return line.part > 0 ? view.turn(line.direction) * (1 / (line.part * s.radius[i])) : base::Vec3f{};
            };
            out[count++] = {s.x[i],
                            s.y[i],
                            z,
                            s.gradX[i],
                            s.gradY[i],
                            view.nearness(z + range),
                            view.nearness(std::max(z - range, 0.01f * z)),
                            behind ? view.nearness(z - backClip * s.rise[i]) : std::numeric_limits<float>::infinity(),
                            1 / (radius * radius),
                            (mean + filter) * layerDepth,
                            s.back[i] > solidAway && style.backsFarther > 0 ? style.backsFarther
                            : behind                                        ? (mean + filter) * layerDepth * backBias
                                                                            : 0,
                            s.normalX[i],
                            s.normalY[i],
                            s.normalZ[i],
                            mask[i],
                            shown ? shown[cluster * clusterSize + i] : colour[i],
                            static_cast<std::uint8_t>(s.left[i]),
                            static_cast<std::uint8_t>(s.right[i]),
                            static_cast<std::uint8_t>(s.top[i]),
                            static_cast<std::uint8_t>(s.bottom[i]),
                            edge(cut),
                            edge(cut.second),
                            shaped ? base::Vec3f{s.shapeX[i], s.shapeY[i], s.shapeZ[i]} : base::Vec3f{}};
        }
    }
    return count;
}

/// Depth and squared radius at 8 pixels in a row; a radius above 1 is outside.
template <class D>
struct Fragments {
    hn::Vec<D> z, r2;
};

/// `r2`, or more than 1 where a plane cuts the fragment away. `w`: its nearness.
template <class D, class V>
HWY_INLINE V uncut(D d, const Splat& s, const ViewFrame& view, V dx, float dy, V w, V r2) {
    for (int k = 0; k < view.clipCount; ++k) {
        const ViewClip& clip = view.clips[static_cast<std::size_t>(k)];
        const float row = clip.normal.x * s.x + clip.normal.y * (s.y + dy) + clip.constant;
        const V side = hn::MulAdd(hn::Set(d, clip.normal.x), dx, hn::Set(d, row));
        r2 = hn::IfThenElse(hn::Lt(side, hn::Mul(hn::Set(d, clip.factor), w)), hn::Set(d, 2.0f), r2);
    }
    return r2;
}

/// `dx`: way from the splat's centre in the image; `row`: w at dx = 0; `dy2`: squared distance down, in filter units.
template <bool parallel, bool isCut, bool shaped, class D, class V>
HWY_INLINE Fragments<D> meet(D d, const Splat& s, const ViewFrame& view, V dx, float dy, float row, float dy2,
                             float filter) {
    const V exact = hn::MulAdd(hn::Set(d, s.gradX), dx, hn::Set(d, row));
    const V inverse = hn::Clamp(exact, hn::Set(d, s.low), hn::Set(d, s.high));
    const V z = parallel ? hn::Neg(inverse) : hn::Div(hn::Set(d, 1.0f), inverse);
    const V dz = hn::Sub(z, hn::Set(d, s.z));
    const V ax = parallel ? dx : hn::MulAdd(dz, hn::Set(d, s.x), hn::Mul(z, dx));
    const V ay = parallel ? hn::Set(d, dy) : hn::MulAdd(dz, hn::Set(d, s.y), hn::Mul(z, hn::Set(d, dy)));
    const auto along = [&](const base::Vec3f& to) HWY_ATTR {
        return hn::MulAdd(ax, hn::Set(d, to.x), hn::MulAdd(ay, hn::Set(d, to.y), hn::Mul(dz, hn::Set(d, to.z))));
    };
    V distanceSq = hn::MulAdd(ax, ax, hn::MulAdd(ay, ay, hn::Mul(dz, dz)));
    if constexpr (shaped) {
        const V off = along(s.shape);
        distanceSq = hn::MulAdd(off, off, distanceSq);
    }
    V onDisc = hn::Mul(distanceSq, hn::Set(d, s.inverseRadiusSq));
    onDisc = hn::IfThenElse(hn::Gt(exact, hn::Set(d, s.cut)), hn::Set(d, 2.0f), onDisc);
    if constexpr (isCut)
        onDisc = hn::IfThenElse(hn::Gt(hn::Max(along(s.edge), along(s.secondEdge)), hn::Set(d, 1.0f)), hn::Set(d, 2.0f),
                                onDisc);
    const V onScreen = hn::MulAdd(hn::Mul(dx, hn::Set(d, filter)), dx, hn::Set(d, dy2));
    return {z, uncut(d, s, view, dx, dy, inverse, hn::Min(onDisc, onScreen))};
}

/// exp(-2 t) on [0, 1] to 7e-5: a cubic for exp(-t/2), raised to the fourth power.
template <class D, class V>
HWY_INLINE V weightOf(D d, V t) {
    V e = hn::MulAdd(hn::Set(d, -0.016275786f), t, hn::Set(d, 0.12227173f));
    e = hn::MulAdd(e, t, hn::Set(d, -0.4994637f));
    e = hn::MulAdd(e, t, hn::Set(d, 0.9999833f));
    e = hn::Mul(e, e);
    return hn::Mul(e, e);
}

/// Calls fn(place, fragments) for the vectors of pixels that may lie in the splat.
template <bool parallel, bool isCut, bool shaped, class D, class Fn>
HWY_INLINE void forFragmentsOf(D d, const Splat& s, const ViewFrame& view, const TileArea& area, const Fn& fn) {
    constexpr float filterSq = filterPx * filterPx;
    const float filter = view.focalPx * view.focalPx / filterSq;
    const float x0 = view.slopeX(area.left + s.left) - s.x;
    const auto first = hn::MulAdd(hn::Iota(d, 0.0f), hn::Set(d, view.step), hn::Set(d, x0));
    const auto jump = hn::Set(d, view.step * static_cast<float>(hn::Lanes(d)));
    for (int y = s.top; y <= s.bottom; ++y) {
        const float dy = view.slopeY(area.top + y) - s.y;
        const float row = (parallel ? -s.z : 1 / s.z) + s.gradY * dy, dy2 = dy * dy * filter;
        auto dx = first;
        for (int x = s.left; x <= s.right; x += static_cast<int>(hn::Lanes(d)), dx = hn::Add(dx, jump))
            fn(y * tileStride + x, meet<parallel, isCut, shaped>(d, s, view, dx, dy, row, dy2, filter));
    }
}

template <bool parallel, class D, class Fn>
HWY_INLINE void forFragments(D d, const Splat& s, const ViewFrame& view, const TileArea& area, const Fn& fn) {
    const bool isCut = !(s.edge == base::Vec3f{});
    if (!(s.shape == base::Vec3f{}))
        isCut ? forFragmentsOf<parallel, true, true>(d, s, view, area, fn)
              : forFragmentsOf<parallel, false, true>(d, s, view, area, fn);
    else if (isCut)
        forFragmentsOf<parallel, true, false>(d, s, view, area, fn);
    else
        forFragmentsOf<parallel, false, false>(d, s, view, area, fn);
}

template <bool parallel>
HWY_INLINE void visibilityOf(std::span<const Splat> splats, const ViewFrame& view, const TileArea& area,
                             TileSums& sums) {
    const HWY_CAPPED(float, 8) d;
    const auto one = hn::Set(d, 1.0f);
    for (const Splat& s : splats)
        forFragments<parallel>(d, s, view, area, [&](int at, const auto& f) HWY_ATTR {
            const auto old = hn::LoadU(d, sums.limit + at);
            const auto limit = hn::Min(old, hn::Add(f.z, hn::Set(d, s.reach + s.bias)));
            hn::StoreU(hn::IfThenElse(hn::Le(f.r2, one), limit, old), d, sums.limit + at);
        });
}

void visibility(std::span<const Splat> splats, const ViewFrame& view, const TileArea& area, TileSums& sums) {
    if (view.parallel)
        visibilityOf<true>(splats, view, area, sums);
    else
        visibilityOf<false>(splats, view, area, sums);
}

template <class D, class V>
HWY_INLINE void accumulate(D d, float* sum, V weight, V value) {
    hn::StoreU(hn::MulAdd(weight, value, hn::LoadU(d, sum)), d, sum);
}

template <bool parallel, bool colours>
HWY_INLINE void attributesOf(const Splat& s, const ViewFrame& view, const TileArea& area, TileSums& sums) {
    const HWY_CAPPED(float, 8) d;
    forFragments<parallel>(d, s, view, area, [&](int at, const auto& f) HWY_ATTR {
        const auto nearest = hn::Le(hn::Add(f.z, hn::Set(d, s.bias)), hn::LoadU(d, sums.limit + at));
        const auto inside = hn::And(nearest, hn::Le(f.r2, hn::Set(d, 1.0f)));
        if (hn::AllFalse(d, inside))
            return;
        const auto weight = hn::IfThenElseZero(inside, weightOf(d, f.r2));
        hn::StoreU(hn::Add(hn::LoadU(d, sums.weight + at), weight), d, sums.weight + at);
        accumulate(d, sums.depth + at, weight, f.z);
        accumulate(d, sums.normal[0] + at, weight, hn::Set(d, s.normalX));
        accumulate(d, sums.normal[1] + at, weight, hn::Set(d, s.normalY));
        accumulate(d, sums.normal[2] + at, weight, hn::Set(d, s.normalZ));
        if constexpr (colours) {
            for (int k = 0; k < 3; ++k)
                accumulate(d, sums.colour[k] + at, weight, hn::Set(d, static_cast<float>(s.colour >> (8 * k) & 255u)));
            accumulate(d, sums.mask + at, weight, hn::Set(d, s.mask));
        }
    });
}

template <bool parallel>
HWY_INLINE void allAttributes(std::span<const Splat> splats, const ViewFrame& view, const SplatStyle& style,
                              const TileArea& area, TileSums& sums) {
    if (style.colours)
        for (const Splat& s : splats)
            attributesOf<parallel, true>(s, view, area, sums);
    else
        for (const Splat& s : splats)
            attributesOf<parallel, false>(s, view, area, sums);
}

void attributes(std::span<const Splat> splats, const ViewFrame& view, const SplatStyle& style, const TileArea& area,
                TileSums& sums) {
    if (view.parallel)
        allAttributes<true>(splats, view, style, area, sums);
    else
        allAttributes<false>(splats, view, style, area, sums);
}

float farthest(const TileArea& area, const TileSums& sums) {
    const HWY_CAPPED(float, 8) d;
    auto most = hn::Zero(d);
    for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < tileWidth; x += static_cast<int>(hn::Lanes(d)))
            most = hn::Max(most, hn::LoadU(d, sums.limit + y * tileStride + x));
    return hn::GetLane(hn::MaxOfLanes(d, most));
}

} // namespace HWY_NAMESPACE
} // namespace render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace render {

HWY_EXPORT(gather);
HWY_EXPORT(visibility);
HWY_EXPORT(attributes);
HWY_EXPORT(farthest);

void clearTile(const TileArea& area, bool colours, TileSums& sums) {
    for (int y = 0; y < area.height; ++y) {
        float* row = sums.limit + y * tileStride;
        std::fill(row, row + area.width, std::numeric_limits<float>::infinity());
        std::fill(row + area.width, row + tileStride, 0.0f);
    }
    const auto clear = [](float* values) { std::fill(values, values + tileHeight * tileStride, 0.0f); };
    clear(sums.weight);
    clear(sums.depth);
    for (int k = 0; k < 3; ++k)
        clear(sums.normal[k]);
    if (!colours)
        return;
    for (int k = 0; k < 3; ++k)
        clear(sums.colour[k]);
    clear(sums.mask);
}

int gatherSplats(const BinEntry& entry, const ViewFrame& view, const SplatStyle& style, const TileArea& area,
                 Splat* out) {
    return HWY_DYNAMIC_DISPATCH(gather)(entry, view, style, area, out);
}

void splatVisibility(std::span<const Splat> splats, const ViewFrame& view, const TileArea& area, TileSums& sums) {
    HWY_DYNAMIC_DISPATCH(visibility)(splats, view, area, sums);
}

float farthestLimit(const TileArea& area, const TileSums& sums) {
    return HWY_DYNAMIC_DISPATCH(farthest)(area, sums);
}

void splatAttributes(std::span<const Splat> splats, const ViewFrame& view, const SplatStyle& style,
                     const TileArea& area, TileSums& sums) {
    HWY_DYNAMIC_DISPATCH(attributes)(splats, view, style, area, sums);
}

} // namespace render
#endif
