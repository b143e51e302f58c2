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

} // namespace render
