// Pictures of a document without a window: what `render` and `run --render` draw.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"
#include "ui/render/renderer.h"

#include <filesystem>
#include <string>

namespace app {

struct PictureOptions {
    bool rayCast = false;        ///< the true surface, every pixel; else splats
    std::string backend = "cpu"; ///< of splats
    render::RenderOptions style;
};

/// What it cost, as `render --stats` tells it.
struct PictureStats {
    std::size_t rays = 0, pixels = 0, evaluations = 0;
    double seconds = 0;
};

render::Image draw(const surface::Surface& surface, const render::Camera& camera, const PictureOptions& options,
                   PictureStats& stats, const base::Progress& progress);

} // namespace app
