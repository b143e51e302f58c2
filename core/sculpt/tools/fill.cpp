#include "core/sculpt/tools/fill.h"

#include "core/sculpt/tools/to_plane.h"

#include <cmath>

namespace sculpt {

static tree::Edit fill(const surface::Surface& version, const Dab& dab) {
    return toPlane(version, dab, dab.strength < 0 ? PlaneSide::Above : PlaneSide::Below, std::abs(dab.strength));
}

const ToolRow fillTool{"fill",
                       "Fill",
                       "icons/tool-fill.svg",
                       "",
                       "Raises hollows to the mean plane; inverted, scrapes bumps down to it.",
                       Motion::Along,
                       0.5,
                       planeParameters,
                       fill,
                       Writes::Shape,
                       {.plane = true}};

} // namespace sculpt
