#include "core/sculpt/tools/to_plane.h"

#include "core/sculpt/tools/displace.h"

#include <algorithm>

namespace sculpt {

/// Part of the way to the plane that a dab of full strength goes.
constexpr float pace = 0.2f;
/// Length of the soft start, in radii.
constexpr float softness = 1.0f / 64;

constexpr ToolParameter parameters[] = {
    {"offset", "Plane offset", "radii", "Height of the plane above the mean of the surface under the brush.", 0.0, -1.0,
     1.0},
};
const std::span<const ToolParameter> planeParameters = parameters;

tree::Edit toPlane(const surface::Surface& version, const Dab& dab, PlaneSide side, float strength) {
    const Brush brush(dab);
    const float full = strength * pace, e = softness * dab.radius;
    if (full == 0)
        return {};
    const base::Vec3f n = dab.areaNormal;
    const float plane = dot(n, dab.areaCentre - dab.centre) + dab.parameter("offset") * dab.radius;
    const bool both = side == PlaneSide::Both;
    const float sign = side == PlaneSide::Above ? -1.0f : 1.0f; // of y, on the side that moves
    return displace(version.tree(), brush, n, [&](const BrushLanes& at, AmountLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        for (std::size_t i = 0; i < lanes; ++i) {
            const float off = plane - (n.x * at.x[i] + n.y * at.y[i] + n.z * at.z[i]); // -x
            const float side1 = std::max(0.0f, sign * off);
            const float soft = side1 * side1 / (side1 + e);
            const float softSlope = side1 * (side1 + 2 * e) / ((side1 + e) * (side1 + e));
            const float y = both ? off : sign * soft, slope = both ? 1.0f : softSlope; // dy / d(-x)
            const float k = full * gradient[i] * y, fall = full * weight[i] * slope;
            out.amount[i] = full * weight[i] * y;
            out.gx[i] = k * at.x[i] - fall * n.x;
            out.gy[i] = k * at.y[i] - fall * n.y;
            out.gz[i] = k * at.z[i] - fall * n.z;
        }
    });
}

} // namespace sculpt
