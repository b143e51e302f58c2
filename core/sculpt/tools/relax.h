// Relax: evens the spacing of the surfels and leaves the surface where it is.
//
//     resampling (core/process/resampling/resample.h) of what is under the brush, all of it awake, at the spacing that
//     is there: d = sum 0.2 (1.5 s - l) t / |t| along the surface, landed on the version, round(5 |strength|) sweeps,
//     at least 1
//
// s is one where the supports under the brush are alike, else each surfel's own (kept_spacing.h), so that fine detail
// stays as fine. What is closer than 0.6 s becomes one surfel, gaps are filled. A margin of 1.5 spacings inside the rim
// stays, so that nothing crosses it; of the falloff it counts where it is above 0. Colours, masks and heights go along.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow relaxTool;

} // namespace sculpt
