#include "ui/render/raycast_image.h"

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

/// Pixels asked for together, in squares: neighbours in the list are neighbours in space.
constexpr int squareSide = 128;

/// Colours of the measured numbers where the rays met the surface.
static void colourHits(const Measured& measured, const Camera& camera, std::vector<raycast::Sample>& samples,
                       const base::Progress& progress) {
    std::vector<std::size_t> pixels;
    std::vector<Vec3f> x;
    std::vector<float> values;
    const auto ask = [&](int left, int top) {
        pixels.clear(), x.clear();
        for (int row = top; row < std::min(top + squareSide, camera.height); ++row)
            for (int column = left; column < std::min(left + squareSide, camera.width); ++column) {
                const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) +
                               static_cast<std::size_t>(column);
                if (!samples[i].hit.hit)
                    continue;
                pixels.push_back(i);
                x.push_back(samples[i].hit.position);
            }
        values.resize(x.size());
        process::quantityAt(measured.question, x, values);
        for (std::size_t k = 0; k < pixels.size(); ++k)
            samples[pixels[k]].colour = measured.scale.of(values[k]);
    };
    for (int top = 0; top < camera.height; top += squareSide)
        for (int left = 0; left < camera.width; left += squareSide) {
            progress.step(static_cast<double>(top) / camera.height, "Measuring the surface");
            ask(left, top);
        }
}

void rayCast(const surface::Surface& surface, const Camera& camera, const RenderOptions& options, Image& out,
             raycast::CastCounts& counts, const base::Progress& progress, const Measured* measured) {
    auto samples = raycast::fullCast(surface, imageRays(camera), counts, progress);
    if (measured)
        colourHits(*measured, camera, samples, progress);
    const auto kind = [&](std::size_t i) { return samples[i].hit.hit ? PixelKind::Surface : PixelKind::Background; };
    const ShadedLayer layer = shadeSamples(samples, kind, *surface.tree().layout(), camera, options.shading);
    showLayer(layer, camera, options, out);
}

} // namespace render
