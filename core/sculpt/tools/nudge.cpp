#include "core/sculpt/tools/nudge.h"

#include "core/sculpt/tools/along_surface.h"
#include "core/sculpt/tools/displace.h"

namespace sculpt {

static tree::Edit nudge(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const base::Vec3f m = alongSurface(dab) * dab.strength;
    if (m == base::Vec3f{})
        return {};
    return displace(version.tree(), brush, m, [&](const BrushLanes& at, AmountLanes& out) {
        alignas(64) float gradient[lanes];
        brush.fade(at, out.amount, gradient);
        for (std::size_t i = 0; i < lanes; ++i)
            out.gx[i] = gradient[i] * at.x[i], out.gy[i] = gradient[i] * at.y[i], out.gz[i] = gradient[i] * at.z[i];
    });
}

const ToolRow nudgeTool{"nudge",
                        "Nudge",
                        "icons/tool-nudge.svg",
                        "",
                        "Pushes the surface along itself, in the direction of the stroke.",
                        Motion::Follow,
                        0.5,
                        {},
                        nudge};

} // namespace sculpt
