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
    constexpr int count = 28;
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
    const auto pixels = [&](float count) { return std::max(1, static_cast<int>(std::lround(count * pixelScale))); };
    if (effects & EyeDome)
        for (const float radius : {1.0f, 2.0f, 4.0f})
            addPairs(pixels(radius), view.step, dome);
    if (effects & Occlusion) {
        const double radius = std::clamp(0.06 * view.height, 4.0, 96.0);
        addDisc(radius, view.step, sky);
        const float far = static_cast<float>(radius) * view.step;
        skyRadiusSq = far * far;
    }
    if (effects & (Outline | Creases | Contours))
        addPairs(pixels(1), view.step, lines);
    if (effects & Creases)
        addPairs(pixels(2), view.step, creases);
    if (effects & Contours)
        addPairs(pixels(3), view.step, contours);
    for (const auto* taps : {&dome, &sky, &lines, &creases, &contours})
        for (const EffectTap& tap : *taps)
            reach = std::max({reach, std::abs(tap.x), std::abs(tap.y)});
}

} // namespace render
