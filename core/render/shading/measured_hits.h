// Colours of measured numbers where rays met the surface.
#pragma once

#include "core/raycast/full_cast.h"
#include "core/render/shading/measured_colours.h"

namespace render {

/// Gives hits the colour of what is measured at their places. Hits that are where one of `before` (as many, or none)
/// is in the same pixel take its colour over. Throws base::Cancelled.
void colourHits(const Measured& measured, int width, std::span<raycast::Sample> samples,
                std::span<const raycast::Sample> before, const base::Progress& progress);

} // namespace render
