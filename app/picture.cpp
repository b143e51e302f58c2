#include "app/picture.h"

#include "ui/render/raycast_image.h"

#include <chrono>

namespace app {

render::Image draw(const surface::Surface& surface, const render::Camera& camera, const PictureOptions& options,
                   PictureStats& stats, const base::Progress& progress) {
    render::Image out;
    out.resize(camera.width, camera.height);
    stats.pixels = out.colour.size();
    const auto begin = std::chrono::steady_clock::now();
    if (options.rayCast) {
        raycast::CastCounts counts;
        render::rayCast(surface, camera, options.style, out, counts, progress);
        stats.rays = counts.rays;
        stats.evaluations = counts.evaluations;
    } else {
        progress.step(0, "Drawing");
        render::makeRenderer(options.backend)->render(surface.tree(), camera, options.style, out);
    }
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

} // namespace app
