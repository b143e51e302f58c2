#include "core/render/picture.h"

#include "core/base/error.h"
#include "core/cells/cell_section.h"
#include "core/render/cast/raycast_image.h"
#include "core/render/overlay/annotation_canvas.h"
#include "core/render/overlay/seam_curves.h"
#include "core/render/shading/measured_colours.h"
#include "core/render/smooth_image.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/splat_scale.h"

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

struct PictureMaker::Kept {
    std::optional<Measured> measured;
    std::unique_ptr<Renderer> renderer;
    RenderOptions style; ///< of splats
    ClipPlanes clips;    ///< that the curves belong to
    SectionCurves curves;
    std::optional<std::vector<surface::SectionCurve>> seams; ///< drawn like these
    std::optional<raycast::AdaptiveCast> caster;
};

PictureMaker::PictureMaker(surface::Surface surface, PictureOptions options)
    : m_surface(std::move(surface)), m_options(std::move(options)), m_kept(std::make_unique<Kept>()) {}

PictureMaker::~PictureMaker() = default;

void PictureMaker::measure(const base::Progress& progress) {
    const auto& row = shadingRow(m_options.style.shading).measure;
    if (!row || m_kept->measured)
        return;
    const process::FieldQuestion question = row->question(m_surface, m_options.reference, m_options.attribute);
    m_kept->measured = Measured{question, scaleFor(*row, question, m_options.range, nullptr, progress)};
}

void PictureMaker::castRays(const Camera& camera, PictureStats& stats, const base::Progress& progress, Image& out) {
    RayCounts counts;
    const auto& measured = m_kept->measured;
    auto& caster = m_kept->caster;
    if (m_options.quality > 0 && !caster)
        caster.emplace(m_surface);
    rayCast(m_surface, camera, m_options.style, out, counts, progress,
            {measured ? &*measured : nullptr, m_options.lighting, m_options.smoothRays, caster ? &*caster : nullptr,
             m_options.quality});
    stats.rays = counts.cast.rays;
    stats.evaluations = counts.cast.evaluations;
    stats.edgeRays = counts.edgeRays;
    stats.light = counts.light;
}

void PictureMaker::drawSplats(const Camera& camera, const base::Progress& progress, Image& out) {
    const tree::SurfelTree& model = m_surface.tree();
    if (!m_kept->renderer) {
        m_kept->style = m_options.style;
        m_kept->style.definition = m_surface.definition();
        m_kept->style.splatScale *= splatScaleOf(model);
        if (const auto& measured = m_kept->measured)
            m_kept->style.colours =
                coloursOf(process::evaluateField(measured->question, nullptr, progress), measured->scale);
        m_kept->renderer = m_options.renderer ? m_options.renderer() : std::make_unique<CpuSplatter>();
    }
    progress.step(0, "Drawing");
    if (m_options.smooth && isSmall(camera))
        renderSmooth(*m_kept->renderer, model, camera, m_kept->style, out);
    else
        m_kept->renderer->render(model, camera, m_kept->style, out);
}

/// Sections and seams; what cuts the one cuts the other, but a plane does not cut its own sections.
void PictureMaker::addLines(const Camera& camera, const base::Progress& progress, Image& out) {
    if (m_options.seams) {
        if (!m_kept->seams)
            m_kept->seams = seamCurves(m_surface, progress);
        drawSections(curveLines(*m_kept->seams, camera, &out), out);
    }
    if (!m_options.sections)
        return;
    if (!(m_kept->clips == camera.clips)) {
        m_kept->curves.clear();
        for (const base::Plane& plane : camera.clips.all())
            m_kept->curves.push_back(cells::findSection(m_surface, plane, progress));
        m_kept->clips = camera.clips;
    }
    drawSections(sectionLines(m_kept->curves, camera, &out), out);
}

Image PictureMaker::draw(const Camera& camera, PictureStats& stats, const base::Progress& progress) {
    try {
        Image out;
        out.resize(camera.width, camera.height);
        stats.pixels = out.colour.size();
        const auto begin = std::chrono::steady_clock::now();
        measure(progress);
        if (m_kept->measured)
            stats.scale = m_kept->measured->scale;
        if (m_options.rayCast)
            castRays(camera, stats, progress, out);
        else
            drawSplats(camera, progress, out);
        addLines(camera, progress, out);
        const RenderOptions& style = m_options.style;
        paint(annotate(m_options.annotated, camera, stats.scale, style.backdrop, style.pixelScale), out);
        stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return out;
    } catch (const std::bad_alloc&) {
        throw base::Error("not enough memory for a picture of " + std::to_string(camera.width) + " x " +
                              std::to_string(camera.height) + " pixels",
                          "", "choose a smaller size");
    }
}

Image drawPicture(const surface::Surface& surface, const Camera& camera, const PictureOptions& options,
                  PictureStats& stats, const base::Progress& progress) {
    return PictureMaker(surface, options).draw(camera, stats, progress);
}

} // namespace render
