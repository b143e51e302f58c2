#include "core/render/effects/ground_grid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/effects/ground_grid.cpp"
#include "core/base/instruction_sets.h"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 8>;
using V = hn::Vec<D>;

/// How far along an axis of the grid a pixel's ray meets it, and how much a pixel covers there.
struct Measure {
    V place, perPixel;
};

/// Part of the pixel that lines of a width cover.
HWY_INLINE V coverage(D d, const V& away, const V& perPixel, float width) {
    const V clear = hn::NegMulAdd(hn::Div(away, perPixel), hn::Set(d, 1.0f), hn::Set(d, 0.5f * width + 0.5f));
    return hn::Clamp(clear, hn::Zero(d), hn::Set(d, 1.0f));
}

HWY_INLINE V lines(D d, const Measure& m, float cell, float width) {
    const V t = hn::Mul(m.place, hn::Set(d, 1 / cell));
    const V away = hn::Mul(hn::Abs(hn::Sub(t, hn::Round(t))), hn::Set(d, cell));
    const V apart = hn::Div(hn::Set(d, cell), m.perPixel);
    const V fade = hn::Mul(hn::Sub(apart, hn::Set(d, gridFadeFrom * width)),
                           hn::Set(d, 1 / ((gridFadeTo - gridFadeFrom) * width)));
    return hn::Mul(coverage(d, away, m.perPixel, width), hn::Clamp(fade, hn::Zero(d), hn::Set(d, 1.0f)));
}

HWY_INLINE void row(const GridPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int y, int left,
                    int right, surfel::Colour* colours) {
    const D d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), step = hn::Set(d, view.step);
    const V sy = hn::Set(d, view.slopeY(y));
    const auto along = [&](const base::Vec3f& axis, V px, V py, V pz) HWY_ATTR {
        return hn::MulAdd(hn::Set(d, axis.x), px, hn::MulAdd(hn::Set(d, axis.y), py, hn::Mul(hn::Set(d, axis.z), pz)));
    };
    for (int x = left; x < right; x += lanes) {
        const V column = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(x)));
        const V sx = hn::MulAdd(column, step, hn::Set(d, view.x0));
        // The meeting place z (sx, sy, 1), or (sx, sy, z), and how it moves with sx and sy.
        const V steep = plan.parallel ? hn::Set(d, plan.normal.z) : along(plan.normal, sx, sy, one);
        const V inverse = hn::Div(one, steep);
        const V z = plan.parallel ? hn::Mul(hn::Sub(hn::Set(d, plan.offset), along(plan.normal, sx, sy, zero)), inverse)
                                  : hn::Mul(hn::Set(d, plan.offset), inverse);
        const V nearness = plan.parallel ? hn::Neg(z) : hn::Div(one, z);
        const auto seen = hn::And(hn::Gt(z, zero), hn::Gt(nearness, hn::LoadU(d, geometry.nearness(y) + x)));
        if (hn::AllFalse(d, seen))
            continue;
        const V dzx = hn::Mul(hn::Set(d, -plan.normal.x), inverse), dzy = hn::Mul(hn::Set(d, -plan.normal.y), inverse);
        const auto measure = [&](const base::Vec3f& axis, float start) HWY_ATTR {
            const V ax = hn::Set(d, axis.x), ay = hn::Set(d, axis.y);
            V place, gx, gy;
            if (plan.parallel) {
                place = along(axis, sx, sy, z);
                gx = hn::MulAdd(hn::Set(d, axis.z), dzx, ax), gy = hn::MulAdd(hn::Set(d, axis.z), dzy, ay);
            } else {
                const V onRay = along(axis, sx, sy, one);
                place = hn::Mul(onRay, z);
                gx = hn::Mul(z, hn::MulAdd(onRay, dzx, ax)), gy = hn::Mul(z, hn::MulAdd(onRay, dzy, ay));
            }
            const V size = hn::Sqrt(hn::MulAdd(gx, gx, hn::Mul(gy, gy)));
            return Measure{hn::Sub(place, hn::Set(d, start)), hn::Max(hn::Mul(size, step), hn::Set(d, 1e-30f))};
        };
        const Measure u = measure(plan.along, plan.alongStart), v = measure(plan.across, plan.acrossStart);
        const V minor = hn::Max(lines(d, u, plan.cell, plan.width), lines(d, v, plan.cell, plan.width));
        const V major = hn::Max(lines(d, u, 10 * plan.cell, plan.width), lines(d, v, 10 * plan.cell, plan.width));
        const V red = coverage(d, hn::Abs(v.place), v.perPixel, plan.width);
        const V blue = coverage(d, hn::Abs(u.place), u.perPixel, plan.width);
        const V q = hn::NegMulAdd(hn::MulAdd(u.place, u.place, hn::Mul(v.place, v.place)),
                                  hn::Set(d, plan.inverseRadiusSq), one);
        const V fade = hn::IfThenElseZero(seen, hn::Mul(hn::Max(q, zero), hn::Max(q, zero)));
        V cover = hn::Max(hn::Mul(minor, hn::Set(d, gridMinor)), hn::Mul(major, hn::Set(d, gridMajor)));
        cover = hn::Max(cover, hn::Mul(hn::Max(red, blue), hn::Set(d, gridAxis)));
        HWY_ALIGN float covers[8], reds[8], blues[8];
        hn::Store(hn::Mul(cover, fade), d, covers);
        hn::Store(red, d, reds);
        hn::Store(blue, d, blues);
        for (int i = 0; i < std::min(lanes, right - x); ++i) {
            if (!(covers[i] > 0))
                continue;
            surfel::Colour& pixel = colours[x - left + i];
            const float under = static_cast<float>(pixel >> 24) * (1.0f / 255) * (1 - covers[i]);
            const float alpha = covers[i] + under;
            surfel::Colour out = static_cast<surfel::Colour>(alpha * 255 + 0.5f) << 24;
            for (std::size_t k = 0; k < 3; ++k) {
                float ink = plan.ink[k];
                ink += reds[i] * (gridRed[k] - ink);
                ink += blues[i] * (gridBlue[k] - ink);
                const float old = static_cast<float>(pixel >> (8 * k) & 255u);
                out |= static_cast<surfel::Colour>((255 * ink * covers[i] + old * under) / alpha + 0.5f) << (8 * k);
            }
            pixel = out;
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace render {

HWY_EXPORT(row);

void applyGrid(const GridPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int y, int left, int right,
               surfel::Colour* colours) {
    HWY_DYNAMIC_DISPATCH(row)(plan, view, geometry, y, left, right, colours);
}

} // namespace render
#endif
