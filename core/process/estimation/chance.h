// Samples that were each drawn without regard to the others: supports reach farther there, over the gaps that chance
// leaves (process/README 1.2), and are made for a smaller spacing than they seem to be.
#pragma once

#include "core/surface/surface.h"

#include <algorithm>

namespace process {

/// How much farther, where the nearest neighbour is on the mean at so much of the spacing: .55 where each sample was
/// drawn without regard to the others, .7 and more in scans, .8 where they keep their distance, 1 on a lattice.
inline float reachByChance(float nearest) {
    constexpr float byChance = 0.6f, evenEnough = 0.68f, most = 1.3f;
    return 1 + (most - 1) * std::clamp((evenEnough - nearest) / (evenEnough - byChance), 0.0f, 1.0f);
}

/// The same of the supports about x as they are: 1 where they do not reach farther than their spacing asks for.
float reachByChance(const surface::Surface& surface, const base::Vec3f& x);

} // namespace process
