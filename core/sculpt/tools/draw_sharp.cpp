#include "core/sculpt/tools/draw_sharp.h"

#include "core/sculpt/tools/along_surface.h"
#include "core/sculpt/tools/displace.h"

#include <cmath>

namespace sculpt {

/// Depth of a dab of full strength, in radii.
constexpr float depth = 0.1f;

static tree::Edit drawSharp(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = -dab.strength * depth * dab.radius;
    if (full == 0)
        return {};
    const base::Vec3f across = acrossStroke(dab);
    const bool round = across == base::Vec3f{};
    const float scale = 1 / dab.radius;
    return displace(version.tree(), brush, dab.areaNormal, [&](const BrushLanes& at, AmountLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        for (std::size_t i = 0; i < lanes; ++i) {
            const float side = (across.x * at.x[i] + across.y * at.y[i] + across.z * at.z[i]) * scale;
            const float v = round ? at.r[i] : std::abs(side), left = std::max(0.0f, 1 - v);
            // grad left^2 = tip (p - centre) + edge across
            const float tip = round && v > 1e-6f ? -2 * left * scale * scale / v : 0.0f;
            const float edge = std::copysign(2 * left * scale, -side);
            const float k = full * (gradient[i] * left * left + weight[i] * tip), f = full * weight[i] * edge;
            out.amount[i] = full * weight[i] * left * left;
            out.gx[i] = k * at.x[i] + f * across.x;
            out.gy[i] = k * at.y[i] + f * across.y;
            out.gz[i] = k * at.z[i] + f * across.z;
        }
    });
}

const ToolRow drawSharpTool{"draw-sharp",
                            "Draw Sharp",
                            "icons/tool-draw-sharp.svg",
                            "",
                            "Cuts a groove with a sharp bottom; inverted, raises a sharp ridge.",
                            Motion::Along,
                            0.5,
                            {},
                            drawSharp};

} // namespace sculpt
