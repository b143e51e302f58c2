// Density: makes the sampling under the brush finer; inverted, coarser. The surface stays where it is.
//
//     target spacing  s' = factor * s, inverted s / factor       s: the spacing where the stroke began with it
//     one dab changes the spacing by a factor of at most 1.5^|strength|, towards s'
//     supports        h(p) = H(s) -> H(s'), changing by at most half the depth below the brush's rim
//
// Where the stroke found different supports under the brush, s is each place's own, and a dab works where that is like
// the centre's (sculpt/README 6.4): fine detail under a wide brush is not eaten, a coarse part is not drowned.
//
// A dab of a wide brush sees to some 1200 surfels; later dabs, and the end of the stroke, do what it owes to the others
// (dues.h).
//
// A stroke that passes twice goes no further than s'; the next stroke starts from there. Supports are graded, because
// neighbours with very different ones ripple (sculpt/README 6.4): the full change needs room, and where a coarse target
// leaves none the brush does as much as fits half its radius. Masked surfels stay; new ones are interpolated.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow densityTool;

} // namespace sculpt
