#include "core/render/effects/screen_effects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

/// Half the neighbours of a pixel on a square: one of each opposite pair.
static void addPairs(int radius, float step, std::vector<EffectTap>& out) {
    const int diagonal = std::max(1, static_cast<int>(std::lround(radius * std::numbers::sqrt2 / 2)));
    const int places[4][2] = {{radius, 0}, {0, radius}, {diagonal, diagonal}, {diagonal, -diagonal}};
    for (const auto& [x, y] : places) {
        const float dx = static_cast<float>(x) * step, dy = static_cast<float>(y) * step;
        out.push_back({x, y, dx, dy, 1 / std::sqrt(dx * dx + dy * dy)});
    }
}

/// Evenly over the disc, denser towards its middle: a spiral by the golden angle.
static void addDisc(double radius, float step, std::vector<EffectTap>& out) {
    constexpr int count = EffectPlan::discTaps;
    for (int k = 0; k < count; ++k) {
        const double part = (k + 0.5) / count, r = radius * std::pow(part, 0.8), angle = 2.399963229728653 * k;
        const int x = static_cast<int>(std::lround(r * std::cos(angle)));
        const int y = static_cast<int>(std::lround(r * std::sin(angle)));
        if (x == 0 && y == 0)
            continue;
        const float dx = static_cast<float>(x) * step, dy = static_cast<float>(y) * step;
        out.push_back({x, y, dx, dy, 1 / std::sqrt(dx * dx + dy * dy)});
    }
}

EffectPlan::EffectPlan(Effects wanted, const ViewFrame& view, float pixelScale)
    : effects(wanted), parallel(view.parallel) {
    for (std::size_t i = 0; i < effectCount; ++i) {
        const EffectRow& row = effectRows[i];
        if (!(effects & row.effect))
            continue;
        for (const int radius : row.rings)
            if (radius > 0)
                addPairs(std::max(1, static_cast<int>(std::lround(static_cast<float>(radius) * pixelScale))), view.step,
                         taps[i].all);
        if (row.disc > 0) {
            const double radius = std::clamp(static_cast<double>(row.disc) * view.height, 4.0, 96.0);
            addDisc(radius, view.step, taps[i].all);
            const float far = static_cast<float>(radius) * view.step;
            taps[i].discSq = far * far;
        }
        for (const EffectTap& tap : taps[i].all)
            reach = std::max({reach, std::abs(tap.x), std::abs(tap.y)});
    }
}

} // namespace render
