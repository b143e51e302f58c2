#include "core/sculpt/tools/flatten.h"

#include "core/sculpt/tools/to_plane.h"

#include <cmath>

namespace sculpt {

static tree::Edit flatten(const surface::Surface& version, const Dab& dab) {
    return toPlane(version, dab, PlaneSide::Both, dab.strength);
}

const ToolRow flattenTool{"flatten",
                          "Flatten",
                          "icons/tool-flatten.svg",
                          "Shift+T",
                          "Draws the surface to its mean plane from both sides; inverted, deepens relief.",
                          Motion::Along,
                          0.5,
                          planeParameters,
                          flatten,
                          Writes::Shape,
                          {.plane = true}};

} // namespace sculpt
