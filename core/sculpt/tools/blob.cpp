#include "core/sculpt/tools/blob.h"

#include "core/sculpt/tools/gather_in.h"

#include <cmath>

namespace sculpt {

/// Height of a dab of full strength, in radii; part by which it spreads at full strength and magnification.
constexpr float height = 0.05f, pace = 0.1f;

constexpr ToolParameter parameters[] = {
    {"magnify", "Magnify", "", "How much the surface spreads as it rises.", 0.5, 0.0, 1.0},
};

static tree::Edit blob(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    if (dab.strength == 0)
        return {};
    const base::Vec3f lift = dab.areaNormal * (dab.strength * height * dab.radius);
    const float rate = std::abs(dab.strength) * pace * dab.parameter("magnify");
    return deform(version.tree(), brush, GatherIn(brush, dab, lift, rate));
}

const ToolRow blobTool{"blob",
                       "Blob",
                       "icons/tool-blob.svg",
                       "",
                       "Raises a ball by pushing out and spreading; inverted, a dent.",
                       Motion::Along,
                       0.5,
                       parameters,
                       blob};

} // namespace sculpt
