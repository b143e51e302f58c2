#include "core/render/cast/true_view.h"

#include "core/render/cast/lit_layer.h"
#include "core/render/cast/raycast_image.h"
#include "core/render/cast/smooth_edges.h"
#include "core/render/shading/measured_hits.h"
#include "core/render/tile_mask.h"

namespace render {

/// Do both show the same, their versions apart?
static bool sameLook(const TrueView::Subject& a, const TrueView::Subject& b) {
    const bool colours = a.measured && b.measured
                             ? a.measured->scale == b.measured->scale && a.measured->over == b.measured->over
                             : a.measured == b.measured;
    return a.camera == b.camera && a.options.shading == b.options.shading && colours &&
           a.surface.definition() == b.surface.definition() && a.lighting == b.lighting &&
           (!a.lighting.wanted() || a.options.backdrop == b.options.backdrop);
}

/// Tiles where one of two versions may look otherwise than the other: those that see places where surfels of a block
/// that one of them lacks have weight. Elsewhere f is the same along every ray.
static TileMask touched(const tree::SurfelTree& from, const tree::SurfelTree& to, const ViewFrame& view) {
    TileMask out(view);
    const tree::Diff diff = tree::diff(from, to);
    for (const auto* blocks : {&diff.removed, &diff.added})
        for (const auto& block : *blocks)
            out.add(screenBounds(view, block->box(), block->maxSupport()));
    return out;
}

/// Without what lies in some tiles.
static std::shared_ptr<const ShadedLayer> without(const TileMask& gone, const ShadedLayer& layer) {
    auto out = std::make_shared<ShadedLayer>(layer);
    for (const std::uint32_t tile : gone.tiles()) {
        const int left = static_cast<int>(tile) % gone.columns() * tileWidth;
        const int top = static_cast<int>(tile) / gone.columns() * tileHeight;
        for (int y = top; y < std::min(top + tileHeight, out->height); ++y)
            for (int x = left; x < std::min(left + tileWidth, out->width); ++x)
                out->row(y)[x] = {};
    }
    return out;
}

/// Where `above` knows a pixel, it is taken.
static void lay(const ShadedLayer* above, ShadedLayer& layer) {
    if (above)
        for (std::size_t i = 0; i < layer.pixels.size(); ++i)
            if (above->pixels[i].kind != PixelKind::Unknown)
                layer.pixels[i] = above->pixels[i];
}

std::shared_ptr<const ShadedLayer> TrueView::known(const Subject& subject) {
    if (!m_layer || !sameLook(subject, m_subject))
        return nullptr;
    if (subject.surface.tree() == m_subject.surface.tree())
        return m_layer;
    const TileMask gone = touched(m_subject.surface.tree(), subject.surface.tree(), ViewFrame(subject.camera));
    m_layer = without(gone, *m_layer);
    if (m_lit)
        m_lit = without(gone, *m_lit);
    m_coloured.clear();
    m_subject.surface = subject.surface;
    return m_layer;
}

TrueView::Level TrueView::shaded(const raycast::AdaptiveImage& image, const base::Progress& progress) {
    std::vector<raycast::Sample> measured;
    std::span<const raycast::Sample> samples = image.samples;
    if (m_subject.measured) {
        measured.assign(samples.begin(), samples.end());
        colourHits(*m_subject.measured, m_subject.camera.width, measured, m_coloured, progress);
        m_coloured = std::move(measured);
        samples = m_coloured;
    }
    const auto kind = [&](std::size_t i) {
        return image.known[i] == raycast::Known::Nothing ? PixelKind::Unknown
               : samples[i].hit.hit                      ? PixelKind::Surface
                                                         : PixelKind::Background;
    };
    const SampleShade shade =
        sampleShade(m_subject.options.shading, *m_subject.surface.tree().layout(), m_subject.measured != nullptr);
    m_unlit = shadeSamples(samples, kind, shade, m_subject.camera);
    auto layer = std::make_shared<ShadedLayer>(m_unlit);
    if (m_layer) // a level never knows less than was shown before
        for (std::size_t i = 0; i < layer->pixels.size(); ++i)
            if (layer->pixels[i].kind == PixelKind::Unknown)
                layer->pixels[i] = m_layer->pixels[i];
    lay(m_lit.get(), *layer);
    m_layer = std::move(layer);
    const bool last = image.complete && image.quality <= m_subject.quality;
    return {m_layer, image.quality, last && !m_subject.lighting.wanted() && !m_subject.smooth};
}

static raycast::LightScene sceneOf(const TrueView::Subject& subject, const raycast::ImageRays& rays) {
    return {subject.surface, subject.lighting, viewerOf(subject.camera, subject.options), rays.clips};
}

/// A part of the work, as the whole sees it.
static base::Progress partOf(const base::Progress& whole, double from, double to) {
    base::Progress out;
    out.cancel = whole.cancel;
    if (whole.report)
        out.report = [&whole, from, to](double share, std::string_view what) {
            whole.report(from + (to - from) * share, what);
        };
    return out;
}

/// Coarse light first: slow light has a picture on the way that says what it is going to be.
void TrueView::light(const raycast::AdaptiveImage& image, const OnLevel& onLevel, const base::Progress& progress) {
    const raycast::ImageRays rays = imageRays(m_subject.camera);
    const raycast::LightScene scene = sceneOf(m_subject, rays);
    const std::span<const raycast::Sample> samples = m_subject.measured ? m_coloured : image.samples;
    constexpr int strides[] = {8, 3}; // together an eighth of the work
    constexpr double shares[] = {0, 0.015, 0.125};
    for (std::size_t k = 0; k < std::size(strides); ++k) {
        auto coarse = std::make_shared<ShadedLayer>(m_unlit);
        lightCoarsely(scene, rays, samples, strides[k], *coarse, partOf(progress, shares[k], shares[k + 1]));
        lay(m_lit.get(), *coarse); // what is lit already stays as it is
        m_layer = std::move(coarse);
        onLevel({m_layer, image.quality, false});
    }
    raycast::LightCounts counts;
    lightPixels(scene, seenThrough(rays, samples), m_unlit.pixels, counts, partOf(progress, shares[2], 1));
    m_lit = m_layer = std::make_shared<ShadedLayer>(std::move(m_unlit));
    onLevel({m_layer, image.quality, !m_subject.smooth});
}

TrueView::Level TrueView::smoothed(const raycast::AdaptiveImage& image, const base::Progress& progress) {
    const raycast::ImageRays rays = imageRays(m_subject.camera);
    std::optional<raycast::LightScene> light;
    if (m_subject.lighting.wanted())
        light.emplace(sceneOf(m_subject, rays));
    auto layer = std::make_shared<ShadedLayer>(*m_layer);
    EdgeCounts counts;
    smoothEdges(m_subject.surface, m_subject.camera,
                {m_subject.options.shading, m_subject.measured.get(), light ? &*light : nullptr}, *layer, counts,
                partOf(progress, 1, 1));
    m_layer = std::move(layer);
    if (light)
        m_lit = m_layer;
    return {m_layer, image.quality, true};
}

void TrueView::refine(const Subject& subject, const OnLevel& onLevel, const base::Progress& progress) {
    if (!known(subject))
        m_layer.reset(), m_lit.reset(), m_coloured.clear();
    m_subject = subject;
    if (m_cast)
        m_cast->setSurface(subject.surface);
    else
        m_cast.emplace(subject.surface);
    raycast::CastCounts counts;
    const auto tell = [&](const raycast::AdaptiveImage& image) { onLevel(shaded(image, progress)); };
    const auto image = m_cast->cast(imageRays(m_subject.camera), {subject.quality}, counts, tell, progress);
    if (subject.lighting.wanted())
        light(image, onLevel, progress);
    if (subject.smooth)
        onLevel(smoothed(image, progress));
}

} // namespace render
