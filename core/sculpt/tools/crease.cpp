#include "core/sculpt/tools/crease.h"

#include "core/sculpt/tools/gather_in.h"

#include <cmath>

namespace sculpt {

/// Depth of a dab of full strength, in radii; part of the way to the middle at full strength and pinch.
constexpr float depth = 0.05f, pace = 0.1f;

constexpr ToolParameter parameters[] = {
    {"pinch", "Pinch", "", "How much the sides are drawn together.", 0.5, 0.0, 1.0},
};

static tree::Edit crease(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    if (dab.strength == 0)
        return {};
    const base::Vec3f lift = dab.areaNormal * (-dab.strength * depth * dab.radius);
    const float together = std::abs(dab.strength) * pace * dab.parameter("pinch");
    const float rate = together > 0 ? -together * foldBrake(version, dab) : 0.0f;
    return deform(version.tree(), brush, GatherIn(brush, dab, lift, rate));
}

const ToolRow creaseTool{"crease",
                         "Crease",
                         "icons/tool-crease.svg",
                         "Shift+C",
                         "Cuts a groove and draws its lips together; inverted, a ridge.",
                         Motion::Along,
                         0.5,
                         parameters,
                         crease};

} // namespace sculpt
