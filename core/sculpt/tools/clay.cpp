#include "core/sculpt/tools/clay.h"

#include "core/sculpt/tools/displace.h"

#include <cmath>

namespace sculpt {

/// Part of the way to the plane that a dab of full strength goes.
constexpr float pace = 0.2f;
/// Length of the soft start, in radii.
constexpr float softness = 1.0f / 16;

constexpr ToolParameter parameters[] = {
    {"offset", "Plane offset", "radii", "Height of the plane above the mean of the surface under the brush.", 0.25, 0.0,
     1.0},
};

static tree::Edit clay(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = std::abs(dab.strength) * pace;
    if (full == 0)
        return {};
    const base::Vec3f up = dab.strength < 0 ? -dab.areaNormal : dab.areaNormal;
    const float e = softness * dab.radius;
    // x = top - up . (p - centre)
    const float top = dot(up, dab.areaCentre - dab.centre) + dab.parameter("offset") * dab.radius;
    return displace(version.tree(), brush, up, [&](const BrushLanes& at, AmountLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        for (std::size_t i = 0; i < lanes; ++i) {
            const float below = top - (up.x * at.x[i] + up.y * at.y[i] + up.z * at.z[i]);
            const float x = below > 0 ? below : 0.0f;
            const float s = x * x / (x + e), slope = x * (x + 2 * e) / ((x + e) * (x + e)); // of s over x
            const float a = full * weight[i] * s, k = full * gradient[i] * s, fall = full * weight[i] * slope;
            out.amount[i] = a;
            out.gx[i] = k * at.x[i] - fall * up.x;
            out.gy[i] = k * at.y[i] - fall * up.y;
            out.gz[i] = k * at.z[i] - fall * up.z;
        }
    });
}

const ToolRow clayTool{"clay",
                       "Clay",
                       "icons/tool-clay.svg",
                       "C",
                       "Builds up towards a plane above the surface, hollows first; inverted, cuts down.",
                       Motion::Along,
                       0.5,
                       parameters,
                       clay,
                       Writes::Shape,
                       {.plane = true}};

} // namespace sculpt
