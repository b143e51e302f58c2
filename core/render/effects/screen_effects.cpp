#include "core/render/effects/screen_effects.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/effects/screen_effects.cpp"
#include "core/base/instruction_sets.h"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 8>;
using V = hn::Vec<D>;

/// A vector of pixels of a row, and what lies around them.
struct Neighbourhood {
    const float* w;
    const float* normal[3];
    std::ptrdiff_t stride;
    V middle;      ///< w
    V inverseUnit; ///< 1 / unit
};

HWY_INLINE std::ptrdiff_t at(const Neighbourhood& p, const EffectTap& tap) {
    return tap.y * p.stride + tap.x;
}

HWY_INLINE V smoothStep(D d, float from, float to, V x) {
    const V t =
        hn::Clamp(hn::Mul(hn::Sub(x, hn::Set(d, from)), hn::Set(d, 1 / (to - from))), hn::Zero(d), hn::Set(d, 1.0f));
    return hn::Mul(hn::Mul(t, t), hn::NegMulAdd(hn::Set(d, 2.0f), t, hn::Set(d, 3.0f)));
}

HWY_INLINE V bend(D d, const Neighbourhood& p, const EffectTap& tap) {
    const std::ptrdiff_t away = at(p, tap);
    const V sum = hn::Add(hn::LoadU(d, p.w + away), hn::LoadU(d, p.w - away));
    return hn::Mul(hn::MulSub(hn::Set(d, 0.5f), sum, p.middle), hn::Mul(p.inverseUnit, hn::Set(d, tap.inverseRho)));
}

HWY_INLINE V eyeDome(D d, const Neighbourhood& p, const EffectTaps& taps) {
    V sum = hn::Zero(d);
    for (const EffectTap& tap : taps.all)
        sum = hn::Add(sum, hn::Clamp(bend(d, p, tap), hn::Zero(d), hn::Set(d, domeMost)));
    return hn::Mul(sum, hn::Set(d, 1 / static_cast<float>(taps.all.size())));
}

/// With V from the pixel's point to the tap's, in units of its depth, or model units where rays are parallel.
template <bool parallel>
HWY_INLINE V occlusion(D d, const Neighbourhood& p, const EffectTaps& taps, V rayX, V rayY) {
    const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const V nx = hn::LoadU(d, p.normal[0]), ny = hn::LoadU(d, p.normal[1]), nz = hn::LoadU(d, p.normal[2]);
    const V inverseFar = hn::Set(d, 1 / taps.discSq), bias = hn::Set(d, skyBias);
    const V least = hn::Mul(hn::Set(d, 1e-6f), p.middle);
    V sum = zero;
    for (const EffectTap& tap : taps.all) {
        const V there = hn::LoadU(d, p.w + at(p, tap));
        V deeper, grown;
        if constexpr (parallel) {
            deeper = hn::Sub(p.middle, there);
            grown = one;
        } else {
            grown = hn::Div(p.middle, hn::Max(there, least));
            deeper = hn::Sub(grown, one);
        }
        const V x = hn::MulAdd(deeper, rayX, hn::Mul(hn::Set(d, tap.dx), grown));
        const V y = hn::MulAdd(deeper, rayY, hn::Mul(hn::Set(d, tap.dy), grown)); // down
        const V distanceSq = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(deeper, deeper)));
        const V height = hn::NegMulAdd(nz, deeper, hn::NegMulAdd(ny, y, hn::Mul(nx, x)));
        const V sine = hn::Div(height, hn::Sqrt(hn::Max(distanceSq, hn::Set(d, 1e-30f))));
        const V near = hn::Max(zero, hn::NegMulAdd(distanceSq, inverseFar, one));
        sum = hn::MulAdd(hn::Max(zero, hn::Sub(sine, bias)), near, sum);
    }
    return hn::Mul(sum, hn::Set(d, 1 / static_cast<float>(std::max<std::size_t>(1, taps.all.size()))));
}

/// The largest of the steps that a line may follow or must not cross.
HWY_INLINE V steepest(D d, const Neighbourhood& p, const EffectTaps& taps, bool bothSides) {
    V most = hn::Zero(d);
    for (const EffectTap& tap : taps.all) {
        const V b = bend(d, p, tap);
        most = hn::Max(most, bothSides ? hn::Abs(b) : hn::Neg(b));
    }
    return most;
}

/// n.v there: cosine between the normal and the way to the eye.
HWY_INLINE V facing(D d, const Neighbourhood& p, std::ptrdiff_t away, V rayX, V rayY) {
    const V nx = hn::LoadU(d, p.normal[0] + away), ny = hn::LoadU(d, p.normal[1] + away),
            nz = hn::LoadU(d, p.normal[2] + away);
    const V across = hn::MulAdd(rayX, rayX, hn::MulAdd(rayY, rayY, hn::Set(d, 1.0f)));
    return hn::Div(hn::MulAdd(ny, rayY, hn::NegMulAdd(nx, rayX, nz)), hn::Sqrt(across));
}

HWY_INLINE V creases(D d, const Neighbourhood& p, const EffectTaps& taps, V rayX, V rayY) {
    V most = hn::Zero(d);
    for (const EffectTap& tap : taps.all) {
        const std::ptrdiff_t away = at(p, tap);
        V cosine = hn::Zero(d);
        for (int k = 0; k < 3; ++k)
            cosine = hn::MulAdd(hn::LoadU(d, p.normal[k] + away), hn::LoadU(d, p.normal[k] - away), cosine);
        most = hn::Max(most, hn::Sub(hn::Set(d, 1.0f), cosine));
    }
    const V level = hn::Sub(hn::Set(d, 1.0f), smoothStep(d, stepFrom, stepTo, steepest(d, p, taps, true)));
    const V turned = smoothStep(d, creaseFacingFrom, creaseFacingTo, facing(d, p, 0, rayX, rayY));
    return hn::Mul(hn::Mul(level, turned), smoothStep(d, creaseFrom, creaseTo, most));
}

template <bool parallel>
HWY_INLINE V contours(D d, const Neighbourhood& p, const EffectTaps& taps, V rayX, V rayY) {
    const V here = facing(d, p, 0, rayX, rayY);
    V deepest = hn::Zero(d);
    for (const EffectTap& tap : taps.all) {
        const std::ptrdiff_t away = at(p, tap);
        const V ox = hn::Set(d, parallel ? 0.0f : tap.dx), oy = hn::Set(d, parallel ? 0.0f : tap.dy);
        const V a = facing(d, p, away, hn::Add(rayX, ox), hn::Add(rayY, oy));
        const V b = facing(d, p, -away, hn::Sub(rayX, ox), hn::Sub(rayY, oy));
        // A valley of this pair: both sides face the eye more than the middle.
        deepest = hn::Max(deepest, hn::Min(hn::Sub(a, here), hn::Sub(b, here)));
    }
    const V level = hn::Sub(hn::Set(d, 1.0f), smoothStep(d, stepFrom, stepTo, steepest(d, p, taps, true)));
    const V turned = hn::Sub(hn::Set(d, 1.0f), smoothStep(d, contourFacingFrom, contourFacingTo, here));
    return hn::Mul(hn::Mul(level, turned), smoothStep(d, contourFrom, contourTo, deepest));
}

/// 0xAABBGGRR times a factor, mixed with ink.
template <class DU>
HWY_INLINE hn::Vec<DU> inked(D d, DU du, hn::Vec<DU> colour, V light, V line) {
    const hn::RebindToSigned<D> di;
    hn::Vec<DU> out = hn::And(colour, hn::Set(du, 0xff000000u));
    const V ink = hn::Mul(line, hn::Set(d, 255 * lineInk)), keep = hn::Mul(hn::Sub(hn::Set(d, 1.0f), line), light);
    const auto channel = [&](auto shift) HWY_ATTR {
        constexpr int bits = decltype(shift)::value;
        const auto byte = hn::And(hn::ShiftRight<bits>(colour), hn::Set(du, 255u));
        const V value = hn::MulAdd(hn::ConvertTo(d, hn::BitCast(di, byte)), keep, ink);
        const auto rounded = hn::BitCast(du, hn::ConvertTo(di, hn::Add(value, hn::Set(d, 0.5f))));
        out = hn::Or(out, hn::ShiftLeft<bits>(rounded));
    };
    channel(std::integral_constant<int, 0>{});
    channel(std::integral_constant<int, 8>{});
    channel(std::integral_constant<int, 16>{});
    return out;
}

template <bool parallel>
HWY_INLINE void effectRow(const EffectPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int row,
                          int left, int right, surfel::Colour* colours) {
    const D d;
    const hn::RebindToUnsigned<D> du;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const V rayY = hn::Set(d, parallel ? 0.0f : view.slopeY(row)); // down
    for (int x = left; x < right; x += lanes) {
        Neighbourhood p{geometry.nearness(row) + x, {}, geometry.stride(), {}, {}};
        for (int k = 0; k < 3; ++k)
            p.normal[k] = geometry.normal(k, row) + x;
        p.middle = hn::LoadU(d, p.w);
        const auto seen = hn::Gt(p.middle, hn::Set(d, parallel ? 0.5f * nowhereParallel : nowhere));
        if (hn::AllFalse(d, seen))
            continue;
        p.inverseUnit = parallel ? one : hn::Div(one, hn::IfThenElse(seen, p.middle, one));
        const V column = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(x)));
        const V rayX = parallel ? zero : hn::MulAdd(column, hn::Set(d, view.step), hn::Set(d, view.x0));
        V dark = zero, line = zero;
        if (plan.effects & EyeDome)
            dark = hn::Mul(hn::Set(d, domeStrength), eyeDome(d, p, plan.of(EyeDome)));
        if (plan.effects & Occlusion)
            dark = hn::MulAdd(hn::Set(d, skyStrength), occlusion<parallel>(d, p, plan.of(Occlusion), rayX, rayY), dark);
        if (plan.effects & Outline)
            line = smoothStep(d, stepFrom, stepTo, steepest(d, p, plan.of(Outline), false));
        if (plan.effects & Creases)
            line = hn::Max(line, creases(d, p, plan.of(Creases), rayX, rayY));
        if (plan.effects & Contours)
            line = hn::Max(line, contours<parallel>(d, p, plan.of(Contours), rayX, rayY));
        const V light = hn::Div(one, hn::MulAdd(dark, hn::MulAdd(hn::Set(d, 0.5f), dark, one), one));
        const V ink = hn::IfThenElseZero(seen, hn::Mul(line, hn::Set(d, lineStrength)));
        surfel::Colour* to = colours + (x - left);
        HWY_ALIGN surfel::Colour some[8] = {};
        const int count = std::min(lanes, right - x);
        std::copy(to, to + count, some);
        const auto old = hn::Load(du, some);
        hn::Store(inked(d, du, old, hn::IfThenElse(seen, light, one), ink), du, some);
        std::copy(some, some + count, to);
    }
}

void effects(const EffectPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int row, int left, int right,
             surfel::Colour* colours) {
    (plan.parallel ? effectRow<true> : effectRow<false>)(plan, view, geometry, row, left, right, colours);
}

} // namespace HWY_NAMESPACE
} // namespace render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace render {

HWY_EXPORT(effects);

void applyEffects(const EffectPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int row, int left,
                  int right, surfel::Colour* colours) {
    HWY_DYNAMIC_DISPATCH(effects)(plan, view, geometry, row, left, right, colours);
}

} // namespace render
#endif
