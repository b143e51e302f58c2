#include "core/sculpt/tools/scrape.h"

#include "core/sculpt/tools/to_plane.h"

#include <cmath>

namespace sculpt {

static tree::Edit scrape(const surface::Surface& version, const Dab& dab) {
    return toPlane(version, dab, dab.strength < 0 ? PlaneSide::Below : PlaneSide::Above, std::abs(dab.strength));
}

const ToolRow scrapeTool{"scrape",
                         "Scrape",
                         "icons/tool-scrape.svg",
                         "",
                         "Scrapes bumps down to the mean plane; inverted, fills hollows up to it.",
                         Motion::Along,
                         0.5,
                         planeParameters,
                         scrape,
                         Writes::Shape,
                         {.plane = true}};

} // namespace sculpt
