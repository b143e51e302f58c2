// The true surface as an image: every pixel's ray meets it exactly, and the meeting is shaded like a splat.
#pragma once

#include "core/raycast/full_cast.h"
#include "ui/render/measured_colours.h"
#include "ui/render/renderer.h"

namespace render {

/// The rays of the camera's pixels. REQUIRES: the camera outlives the result.
raycast::ImageRays imageRays(const Camera& camera);

/// Throws base::Cancelled. The same bits at any thread count. A shading of measured numbers asks `measured` at every
/// meeting; without it they are unknown.
void rayCast(const surface::Surface& surface, const Camera& camera, const RenderOptions& options, Image& out,
             raycast::CastCounts& counts, const base::Progress& progress = {}, const Measured* measured = nullptr);

} // namespace render
