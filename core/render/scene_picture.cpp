#include "core/render/scene_picture.h"

#include "core/base/parallel.h"
#include "core/render/overlay/annotation_canvas.h"
#include "core/render/shaded_layer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace render {

ScenePictureMaker::ScenePictureMaker(const std::vector<surface::Surface>& models, const PictureOptions& options)
    : m_options(options) {
    PictureOptions own = options;
    if (models.size() > 1) {
        PictureOptions behind = options;
        behind.rayCast = behind.sections = behind.seams = false;
        behind.annotated = 0;
        m_backdrop = std::make_unique<PictureMaker>(surface::Surface(), behind);
        own.annotated = 0;
        own.style.transparent = true;
        own.style.grid.reset();
    }
    for (const surface::Surface& each : models) {
        m_makers.push_back(std::make_unique<PictureMaker>(each, own));
        own.reference = {}; // the first one's
    }
}

/// Of an edge's pixel that is covered in part: that of the nearest beside it.
static float depthAt(const Image& image, std::size_t i) {
    float out = image.depth[i];
    if (std::isfinite(out) || image.colour[i] >> 24 == 0)
        return out;
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t x = i % width;
    if (x > 0)
        out = std::min(out, image.depth[i - 1]);
    if (x + 1 < width)
        out = std::min(out, image.depth[i + 1]);
    if (i >= width)
        out = std::min(out, image.depth[i - width]);
    if (i + width < image.depth.size())
        out = std::min(out, image.depth[i + width]);
    return out;
}

void mergeByDepth(Image& into, const Image& other) {
    assert(into.width == other.width && into.height == other.height);
    constexpr std::size_t chunk = 1 << 16;
    const std::size_t pixels = into.colour.size();
    std::vector<surfel::Colour> colour(pixels);
    std::vector<float> depth(pixels);
    base::parallelFor((pixels + chunk - 1) / chunk, 1, [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(pixels, (c + 1) * chunk); ++i) {
            const bool before = depthAt(other, i) < depthAt(into, i);
            colour[i] = before ? over(other.colour[i], into.colour[i]) : over(into.colour[i], other.colour[i]);
            depth[i] = std::min(into.depth[i], other.depth[i]);
        }
    });
    into.colour = std::move(colour);
    into.depth = std::move(depth);
}

Image ScenePictureMaker::draw(const Camera& camera, PictureStats& stats, const base::Progress& progress) {
    if (!m_backdrop)
        return m_makers.front()->draw(camera, stats, progress);
    Image models;
    models.resize(camera.width, camera.height);
    for (const auto& maker : m_makers) {
        PictureStats one;
        mergeByDepth(models, maker->draw(camera, one, progress));
        if (!stats.scale)
            stats.scale = one.scale;
        stats += one;
    }
    PictureStats none;
    Image out = m_backdrop->draw(camera, none, progress);
    out.depth.assign(out.depth.size(), std::numeric_limits<float>::infinity()); // nothing is behind the ground
    mergeByDepth(models, out);
    paint(annotate(m_options.annotated, camera, stats.scale, m_options.style.backdrop, m_options.style.pixelScale),
          models);
    return models;
}

} // namespace render
