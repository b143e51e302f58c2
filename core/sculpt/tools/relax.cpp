#include "core/sculpt/tools/relax.h"

#include "core/process/resampling/resample.h"
#include "core/sculpt/tools/inside.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// Sweeps of a dab of full strength.
constexpr float sweeps = 5;
/// What stays inside the rim, in spacings.
constexpr float margin = 1.5f;

static tree::Edit relax(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    process::ResampleOptions options;
    options.spacing = process::localSpacing(version, dab.centre);
    options.sweeps = std::max(1, static_cast<int>(std::lround(sweeps * std::abs(dab.strength))));
    options.relaxAll = true;
    if (dab.strength == 0 || !(options.spacing > 0))
        return {};
    return process::resample(version, inside(version.tree(), brush, dab.radius - margin * options.spacing), options);
}

const ToolRow relaxTool{"relax",
                        "Relax",
                        "icons/tool-relax.svg",
                        "",
                        "Evens the spacing of the surfels and leaves the surface where it is.",
                        Motion::Along,
                        0.5,
                        {},
                        relax,
                        Writes::Count};

} // namespace sculpt
