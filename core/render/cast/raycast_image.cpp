#include "core/render/cast/raycast_image.h"

#include "core/render/cast/smooth_edges.h"
#include "core/render/shading/measured_hits.h"

namespace render {

using base::Vec3d;
using base::Vec3f;

raycast::ImageRays imageRays(const Camera& camera) {
    const Vec3d right = camera.right(), down = -camera.upright(), forward = camera.forward();
    const Vec3d aside = right * (0.5 - 0.5 * camera.width) + down * (0.5 - 0.5 * camera.height);
    raycast::ImageRays out;
    out.width = camera.width, out.height = camera.height;
    out.clips = camera.clips.all();
    if (camera.parallel()) {
        const double unit = 1 / camera.focalPx();
        out.eye = camera.eye + aside * unit;
        out.originAcross = right * unit, out.originDown = down * unit;
        out.corner = forward;
    } else {
        out.eye = camera.eye;
        out.corner = forward * camera.focalPx() + aside;
        out.across = right, out.down = down;
    }
    return out;
}

void rayCast(const surface::Surface& surface, const Camera& camera, const RenderOptions& options, Image& out,
             RayCounts& counts, const base::Progress& progress, const RayLook& look) {
    const raycast::ImageRays rays = imageRays(camera);
    std::vector<raycast::Sample> samples;
    if (look.caster) {
        const auto image = look.caster->cast(rays, {look.quality}, counts.cast, {}, progress);
        samples.assign(image.samples.begin(), image.samples.end());
    } else
        samples = raycast::fullCast(surface, rays, counts.cast, progress);
    if (look.measured)
        colourHits(*look.measured, camera.width, samples, {}, progress);
    const auto kind = [&](std::size_t i) { return samples[i].hit.hit ? PixelKind::Surface : PixelKind::Background; };
    const SampleShade shade = sampleShade(options.shading, *surface.tree().layout(), look.measured != nullptr);
    ShadedLayer layer = shadeSamples(samples, kind, shade, camera);
    std::optional<raycast::LightScene> light;
    if (look.lighting.wanted()) {
        light.emplace(surface, look.lighting, viewerOf(camera, options), rays.clips);
        lightPixels(*light, seenThrough(rays, samples), layer.pixels, counts.light, progress);
    }
    if (look.smooth) {
        EdgeCounts edges;
        smoothEdges(surface, camera, {options.shading, look.measured, light ? &*light : nullptr}, layer, edges,
                    progress);
        counts.edgeRays = edges.rays;
        counts.cast.evaluations += edges.evaluations;
        counts.light += edges.light;
    }
    showLayer(layer, camera, options, out);
}

} // namespace render
