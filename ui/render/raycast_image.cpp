#include "ui/render/raycast_image.h"

#include "ui/render/measured_hits.h"
#include "ui/render/shaded_layer.h"

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
             raycast::CastCounts& counts, const base::Progress& progress, const Measured* measured) {
    auto samples = raycast::fullCast(surface, imageRays(camera), counts, progress);
    if (measured)
        colourHits(*measured, camera.width, samples, {}, progress);
    const auto kind = [&](std::size_t i) { return samples[i].hit.hit ? PixelKind::Surface : PixelKind::Background; };
    const ShadedLayer layer = shadeSamples(samples, kind, *surface.tree().layout(), camera, options.shading);
    showLayer(layer, camera, options, out);
}

} // namespace render
