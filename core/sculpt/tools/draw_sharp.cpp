#include "core/sculpt/tools/draw_sharp.h"

#include "core/sculpt/tools/displace.h"

namespace sculpt {

/// Depth of a dab of full strength, in radii.
constexpr float depth = 0.1f;

static tree::Edit drawSharp(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = -dab.strength * depth * dab.radius;
    if (full == 0)
        return {};
    const float scale = 1 / (dab.radius * dab.radius);
    return displace(version.tree(), brush, dab.areaNormal, [&](const BrushLanes& at, AmountLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        for (std::size_t i = 0; i < lanes; ++i) {
            const float left = at.r[i] < 1 ? 1 - at.r[i] : 0.0f;
            const float inwards = at.r[i] > 1e-6f ? -2 * left * scale / at.r[i] : 0.0f; // grad left^2 over p - centre
            const float k = full * (gradient[i] * left * left + weight[i] * inwards);
            out.amount[i] = full * weight[i] * left * left;
            out.gx[i] = k * at.x[i], out.gy[i] = k * at.y[i], out.gz[i] = k * at.z[i];
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
