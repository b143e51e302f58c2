// Light on the pixels of cast rays: shadows and ambient occlusion on what is shaded already, or another material
// instead of the shading; and the shadow on the ground.
#pragma once

#include "core/raycast/illuminate.h"
#include "core/render/shaded_layer.h"

namespace render {

/// Whoever looks through the camera, with the background of the options behind the model.
raycast::Viewer viewerOf(const Camera& camera, const RenderOptions& options);

/// Lights pixels in place: pixels[i] shows seen.samples[i]. Pixels of another kind than Surface and Background, and
/// samples that are neither hit nor ground, stay as they are. In parallel. Throws base::Cancelled.
void lightPixels(const raycast::LightScene& scene, const raycast::SeenSamples& seen,
                 std::span<ShadedLayer::Pixel> pixels, raycast::LightCounts& counts, const base::Progress& progress);

/// A first look at slow light: one pixel of each square of `stride` pixels is lit, and those of the square that show
/// the same side of the same part of the surface take its light; the others stay as they are. Costs about 1 / stride^2
/// of lighting all. `layer` is as large as the image of `rays`. Throws base::Cancelled.
void lightCoarsely(const raycast::LightScene& scene, const raycast::ImageRays& rays,
                   std::span<const raycast::Sample> samples, int stride, ShadedLayer& layer,
                   const base::Progress& progress);

} // namespace render
