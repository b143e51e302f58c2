// The true surface as an image: every pixel's ray meets it exactly, and the point hit is shaded like a splat.
#pragma once

#include "core/raycast/adaptive_cast.h"
#include "core/raycast/lighting.h"
#include "core/render/renderer.h"
#include "core/render/shading/measured_colours.h"

namespace render {

/// The rays of the camera's pixels. REQUIRES: the camera outlives the result.
raycast::ImageRays imageRays(const Camera& camera);

/// How cast rays are shown, beside what RenderOptions say.
struct RayLook {
    const Measured* measured = nullptr; ///< what a shading of measured numbers asks; without it they are unknown
    raycast::Lighting lighting;
    bool smooth = false; ///< pixels at edges are means of nine rays (smooth_edges.h)
    /// Casts the pixels of this surface, at `quality`, with what it kept of earlier views; null: every pixel has a ray.
    raycast::AdaptiveCast* caster = nullptr;
    double quality = 0;
};

struct RayCounts {
    raycast::CastCounts cast;   ///< of the pixels' own rays
    raycast::LightCounts light; ///< shadows, occlusion, paths
    std::size_t edgeRays = 0;
};

/// Throws base::Cancelled. The same bits at any thread count.
void rayCast(const surface::Surface& surface, const Camera& camera, const RenderOptions& options, Image& out,
             RayCounts& counts, const base::Progress& progress = {}, const RayLook& look = {});

} // namespace render
