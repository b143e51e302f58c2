// How far the surfels of a block lie off the surface that they sample together, as those of raw scans do by their noise
// and where scans overlap (render/README 4.5). A measure by neighbours, without the surface: what a picture asks of
// every block must cost little.
//
// Lengths are in model units. No state; safe for threads.
#pragma once

#include "core/surfel/surfel_block.h"

namespace render {

/// A sixteenth of the surfels lie that far off and farther. `radiusOfSupport`: radius of a disc in supports.
float offSurface(const surfel::SurfelBlock& block, float radiusOfSupport);

} // namespace render
