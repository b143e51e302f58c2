#include "core/sculpt/tools/grab.h"

#include "core/sculpt/tools/pull.h"

namespace sculpt {

constexpr ToolParameter parameters[] = {
    {"plateau", "Plateau", "radii", "Part of the brush that moves as one piece.", 0.25, 0.15, 0.5},
};

static tree::Edit grab(const surface::Surface& version, const Dab& dab) {
    Brush brush(dab);
    brush.plateau = dab.parameter("plateau");
    const base::Vec3f m = dab.move * std::abs(dab.strength);
    if (m == base::Vec3f{})
        return {};
    brush.centre += m * 0.5f; // all weights are taken half way
    return displace(version.tree(), brush, m, Pull{brush, m});
}

const ToolRow grabTool{"grab",
                       "Grab",
                       "icons/tool-grab.svg",
                       "G",
                       "Holds what was touched first and carries it with the pointer.",
                       Motion::Drag,
                       1.0,
                       parameters,
                       grab};

} // namespace sculpt
