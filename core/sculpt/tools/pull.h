// The weight with which matter follows a pull, taken half way: w(p) = W(|(p + p')/2 - (centre + m/2)| / R), where
// p' = p + m w(p). Grab says why; W is the brush's falloff with its plateau. REQUIRES: brush.centre is half way itself.
#pragma once

#include "core/sculpt/tools/displace.h"

namespace sculpt {

/// A Field of `displace` with direction m.
struct Pull {
    Brush brush;
    base::Vec3f m;

    void operator()(const BrushLanes& at, AmountLanes& out) const;
};

} // namespace sculpt
