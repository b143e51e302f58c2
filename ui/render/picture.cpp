#include "ui/render/picture.h"

#include "ui/render/raycast_image.h"
#include "ui/render/smooth_image.h"
#include "ui/render/splat_scale.h"

#include <chrono>

namespace render {

/// Smooth outlines take four times the pixels; beyond this many the picture is fine enough without.
constexpr std::size_t mostSmoothPixels = 16u << 20;

static void drawSplats(const tree::SurfelTree& model, const Camera& camera, const PictureOptions& options, Image& out) {
    RenderOptions style = options.style;
    style.splatScale *= splatScaleOf(model);
    const auto renderer = makeRenderer(options.backend);
    if (out.colour.size() <= mostSmoothPixels)
        renderSmooth(*renderer, model, camera, style, out);
    else
        renderer->render(model, camera, style, out);
}

Image drawPicture(const surface::Surface& surface, const Camera& camera, const PictureOptions& options,
                  PictureStats& stats, const base::Progress& progress) {
    Image out;
    out.resize(camera.width, camera.height);
    stats.pixels = out.colour.size();
    const auto begin = std::chrono::steady_clock::now();
    if (options.rayCast) {
        raycast::CastCounts counts;
        rayCast(surface, camera, options.style, out, counts, progress);
        stats.rays = counts.rays;
        stats.evaluations = counts.evaluations;
    } else {
        progress.step(0, "Drawing");
        drawSplats(surface.tree(), camera, options, out);
    }
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

} // namespace render
