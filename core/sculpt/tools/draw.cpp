#include "core/sculpt/tools/draw.h"

#include "core/sculpt/tools/displace.h"

namespace sculpt {

/// Height of a dab of full strength, in radii.
constexpr float height = 0.05f;

static tree::Edit draw(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = dab.strength * height * dab.radius;
    if (full == 0)
        return {};
    return displace(version.tree(), brush, dab.areaNormal, [&](const BrushLanes& at, AmountLanes& out) {
        alignas(64) float gradient[lanes];
        brush.fade(at, out.amount, gradient);
        for (std::size_t i = 0; i < lanes; ++i) {
            out.amount[i] *= full;
            const float k = full * gradient[i];
            out.gx[i] = k * at.x[i], out.gy[i] = k * at.y[i], out.gz[i] = k * at.z[i];
        }
    });
}

const ToolRow drawTool{"draw",
                       "Draw",
                       "icons/tool-draw.svg",
                       "X; V",
                       "Pushes the surface out under the brush; inverted, in.",
                       Motion::Along,
                       0.5,
                       {},
                       draw};

} // namespace sculpt
