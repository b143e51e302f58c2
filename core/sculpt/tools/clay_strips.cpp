#include "core/sculpt/tools/clay_strips.h"

#include "core/sculpt/tools/along_surface.h"
#include "core/sculpt/tools/displace.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// Part of the way to the plane that a dab of full strength goes.
constexpr float pace = 0.3f;
/// Length of the soft start at the plane, in radii.
constexpr float softness = 1.0f / 16;
/// Half the side of the tip, in radii: its corners stay in the ball.
constexpr float halfSide = 0.65f;
/// Part of the half side over which the tip fades.
constexpr float edge = 0.4f;
/// Weight of the falloff from which the tip is whole.
constexpr float wholeFrom = 0.1f;

constexpr ToolParameter parameters[] = {
    {"offset", "Plane offset", "radii", "Height of the plane above the mean of the surface under the brush.", 0.18, 0.0,
     1.0},
};

namespace {

/// smoothstep of t in [0, 1], and its derivative.
struct Step {
    float value, slope;
    explicit Step(float t) {
        t = std::min(1.0f, std::max(0.0f, t));
        value = t * t * (3 - 2 * t);
        slope = 6 * t * (1 - t);
    }
};

struct Strip {
    const Brush& brush;
    base::Vec3f up, along, across; ///< along is zero without a direction
    float top, full;               ///< x = top - up . (p - centre)

    void operator()(const BrushLanes& at, AmountLanes& out) const {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        const bool round = along == base::Vec3f{};
        const float reach = 1 / (halfSide * brush.radius), e = softness * brush.radius;
        for (std::size_t i = 0; i < lanes; ++i) {
            const float px = at.x[i], py = at.y[i], pz = at.z[i], height = up.x * px + up.y * py + up.z * pz;
            const float tx = px - height * up.x, ty = py - height * up.y, tz = pz - height * up.z;
            const float t = std::sqrt(tx * tx + ty * ty + tz * tz), unit = t > 1e-12f * brush.radius ? 1 / t : 0.0f;
            // Two directions in which the tip fades; the round one has one.
            const float ux = round ? tx * unit : along.x, uy = round ? ty * unit : along.y,
                        uz = round ? tz * unit : along.z;
            const float u = ux * px + uy * py + uz * pz, v = across.x * px + across.y * py + across.z * pz;
            const Step bu((1 - std::abs(u) * reach) / edge), bv((1 - std::abs(v) * reach) / edge);
            const Step rim(weight[i] / wholeFrom);
            const float du = std::copysign(bu.slope * reach / edge, -u) * bv.value * rim.value;
            const float dv = std::copysign(bv.slope * reach / edge, -v) * bu.value * rim.value;
            const float dr = rim.slope / wholeFrom * gradient[i] * bu.value * bv.value;
            const float tip = bu.value * bv.value * rim.value;
            const float below = top - height, x = below > 0 ? below : 0.0f;
            const float s = x * x / (x + e), slope = x * (x + 2 * e) / ((x + e) * (x + e)); // of s over x
            const float k = full * s, fall = full * tip * slope;
            out.amount[i] = full * tip * s;
            out.gx[i] = k * (du * ux + dv * across.x + dr * px) - fall * up.x;
            out.gy[i] = k * (du * uy + dv * across.y + dr * py) - fall * up.y;
            out.gz[i] = k * (du * uz + dv * across.z + dr * pz) - fall * up.z;
        }
    }
};

} // namespace

static tree::Edit clayStrips(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = std::abs(dab.strength) * pace;
    if (full == 0)
        return {};
    const base::Vec3f up = dab.strength < 0 ? -dab.areaNormal : dab.areaNormal;
    const base::Vec3f across = acrossStroke(dab), along = cross(across, dab.areaNormal);
    const float top = dot(up, dab.areaCentre - dab.centre) + dab.parameter("offset") * dab.radius;
    return displace(version.tree(), brush, up, Strip{brush, up, along, across, top, full});
}

const ToolRow clayStripsTool{"clay-strips",
                             "Clay Strips",
                             "icons/tool-clay-strips.svg",
                             "",
                             "Lays flat strips with a square tip along the stroke; inverted, cuts them out.",
                             Motion::Along,
                             0.5,
                             parameters,
                             clayStrips,
                             Writes::Shape,
                             {.plane = true}};

} // namespace sculpt
