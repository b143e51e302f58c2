#include "core/sculpt/tools/pinch.h"

#include "core/sculpt/tools/gather_in.h"

namespace sculpt {

/// Part of the way to the middle that a dab of full strength goes.
constexpr float pace = 0.1f;

static tree::Edit pinch(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float together = dab.strength > 0 ? dab.strength * foldBrake(version, dab) : dab.strength;
    if (together == 0)
        return {};
    return deform(version.tree(), brush, GatherIn(brush, dab, {}, -pace * together));
}

const ToolRow pinchTool{"pinch",
                        "Pinch",
                        "icons/tool-pinch.svg",
                        "P",
                        "Draws the surface together under the brush; inverted, spreads it.",
                        Motion::Along,
                        0.5,
                        {},
                        pinch};

} // namespace sculpt
