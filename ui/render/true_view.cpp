#include "ui/render/true_view.h"

#include "ui/render/measured_hits.h"
#include "ui/render/raycast_image.h"
#include "ui/render/tile_mask.h"

namespace render {

/// Do both show the same, their versions apart?
static bool sameLook(const TrueView::Subject& a, const TrueView::Subject& b) {
    const bool colours = a.measured && b.measured ? a.measured->scale == b.measured->scale : a.measured == b.measured;
    return a.camera == b.camera && a.shading == b.shading && colours &&
           a.surface.definition() == b.surface.definition();
}

/// Tiles where one of two versions may look otherwise than the other.
static TileMask touched(const tree::SurfelTree& from, const tree::SurfelTree& to, const ViewFrame& view) {
    TileMask out(view);
    const tree::Diff diff = tree::diff(from, to);
    const float reach = std::max(from.maxSupport(), to.maxSupport());
    for (const auto* blocks : {&diff.removed, &diff.added})
        for (const auto& block : *blocks)
            out.add(screenBounds(view, block->box(), reach));
    return out;
}

std::shared_ptr<const ShadedLayer> TrueView::known(const Subject& subject) {
    if (!m_layer || !sameLook(subject, m_subject))
        return nullptr;
    if (subject.surface.tree() == m_subject.surface.tree())
        return m_layer;
    const ViewFrame view(subject.camera);
    const TileMask gone = touched(m_subject.surface.tree(), subject.surface.tree(), view);
    auto layer = std::make_shared<ShadedLayer>(*m_layer);
    for (const std::uint32_t tile : gone.tiles()) {
        const int left = static_cast<int>(tile) % gone.columns() * tileWidth;
        const int top = static_cast<int>(tile) / gone.columns() * tileHeight;
        for (int y = top; y < std::min(top + tileHeight, view.height); ++y)
            for (int x = left; x < std::min(left + tileWidth, view.width); ++x)
                layer->row(y)[x] = {};
    }
    m_layer = std::move(layer);
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
    auto layer = std::make_shared<ShadedLayer>(
        shadeSamples(samples, kind, *m_subject.surface.tree().layout(), m_subject.camera, m_subject.shading));
    if (m_layer) // a level never knows less than was shown before
        for (std::size_t i = 0; i < layer->pixels.size(); ++i)
            if (layer->pixels[i].kind == PixelKind::Unknown)
                layer->pixels[i] = m_layer->pixels[i];
    m_layer = std::move(layer);
    return {m_layer, image.quality, image.complete};
}

void TrueView::refine(const Subject& subject, const OnLevel& onLevel, const base::Progress& progress) {
    if (!known(subject))
        m_layer.reset(), m_coloured.clear();
    m_subject = subject;
    if (m_cast)
        m_cast->setSurface(subject.surface);
    else
        m_cast.emplace(subject.surface);
    raycast::CastCounts counts;
    const auto tell = [&](const raycast::AdaptiveImage& image) { onLevel(shaded(image, progress)); };
    m_cast->cast(imageRays(m_subject.camera), {subject.quality}, counts, tell, progress);
}

} // namespace render
