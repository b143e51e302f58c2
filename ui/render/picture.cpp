#include "ui/render/picture.h"

#include "core/base/error.h"
#include "ui/render/annotation_canvas.h"
#include "ui/render/measured_colours.h"
#include "ui/render/raycast_image.h"
#include "ui/render/section_lines.h"
#include "ui/render/smooth_image.h"
#include "ui/render/splat_scale.h"

#include <algorithm>
#include <chrono>
#include <new>

namespace render {

/// Smooth outlines take four times the pixels; beyond this many, or of this side, the picture is fine enough without.
constexpr std::size_t mostSmoothPixels = 16u << 20;
constexpr int mostSmoothSide = 8192;

static bool isSmall(const Camera& camera) {
    const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    return pixels <= mostSmoothPixels && std::max(camera.width, camera.height) <= mostSmoothSide;
}

static void drawSplats(const surface::Surface& surface, const Camera& camera, const PictureOptions& options,
                       std::shared_ptr<const BlockColours> colours, Image& out) {
    const tree::SurfelTree& model = surface.tree();
    RenderOptions style = options.style;
    style.definition = surface.definition();
    style.colours = std::move(colours);
    style.splatScale *= splatScaleOf(model);
    const auto renderer = makeRenderer(options.backend);
    if (options.smooth && isSmall(camera))
        renderSmooth(*renderer, model, camera, style, out);
    else
        renderer->render(model, camera, style, out);
}

static void addSections(const surface::Surface& surface, const Camera& camera, const base::Progress& progress,
                        Image& image) {
    SectionCurves curves;
    for (const base::Plane& plane : camera.clips.all())
        curves.push_back(findSection(surface, plane, progress));
    drawSections(curves, camera, image);
}

static Image draw(const surface::Surface& surface, const Camera& camera, const PictureOptions& options,
                  PictureStats& stats, const base::Progress& progress) {
    Image out;
    out.resize(camera.width, camera.height);
    stats.pixels = out.colour.size();
    const auto begin = std::chrono::steady_clock::now();
    std::optional<Measured> measured;
    if (const auto& row = shadingRow(options.style.shading).measure) {
        const process::FieldQuestion question{row->quantity, surface, options.reference};
        measured = Measured{question, scaleFor(*row, question, options.range, nullptr, progress)};
        stats.scale = measured->scale;
    }
    if (options.rayCast) {
        const auto cast = [&](const Camera& view, Image& image) {
            raycast::CastCounts counts;
            rayCast(surface, view, options.style, image, counts, progress, measured ? &*measured : nullptr);
            stats.rays += counts.rays;
            stats.evaluations += counts.evaluations;
        };
        if (options.smoothRays && isSmall(camera))
            renderSmooth(camera, cast, out);
        else
            cast(camera, out);
    } else {
        std::shared_ptr<const BlockColours> colours;
        if (measured)
            colours = coloursOf(process::evaluateField(measured->question, nullptr, progress), measured->scale);
        progress.step(0, "Drawing");
        drawSplats(surface, camera, options, std::move(colours), out);
    }
    if (options.sections)
        addSections(surface, camera, progress, out);
    paint(annotate(options.annotated, camera, stats.scale, options.style.backdrop, options.style.pixelScale), out);
    stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

Image drawPicture(const surface::Surface& surface, const Camera& camera, const PictureOptions& options,
                  PictureStats& stats, const base::Progress& progress) {
    try {
        return draw(surface, camera, options, stats, progress);
    } catch (const std::bad_alloc&) {
        throw base::Error("the memory does not hold a picture of " + std::to_string(camera.width) + " x " +
                              std::to_string(camera.height) + " pixels",
                          "", "choose a smaller size");
    }
}

} // namespace render
