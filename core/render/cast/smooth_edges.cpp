#include "core/render/cast/smooth_edges.h"

#include "core/base/parallel.h"
#include "core/raycast/cast_pixels.h"
#include "core/render/cast/raycast_image.h"
#include "core/render/shading/measured_hits.h"

namespace render {

/// Places within a pixel, of 8 x 8: one in each row and column.
constexpr int fine = 8;
constexpr raycast::Pixel places[] = {{4, 2}, {3, 5}, {6, 4}, {2, 1}, {1, 6}, {0, 3}, {5, 7}, {7, 0}};
constexpr int each = static_cast<int>(std::size(places));

/// Pixels whose rays are cast together.
constexpr std::size_t batchSize = 8192;

static bool standsOut(surfel::Colour a, surfel::Colour b) {
    constexpr int most = 14; // of 255
    for (int k = 0; k < 32; k += 8)
        if (std::abs(static_cast<int>(a >> k & 255u) - static_cast<int>(b >> k & 255u)) > most)
            return true;
    return false;
}

static std::vector<std::size_t> edgesOf(const ShadedLayer& layer) {
    std::vector<std::size_t> out;
    const auto colour = [&](int x, int y) { return layer.row(y)[x].colour; };
    for (int y = 0; y < layer.height; ++y)
        for (int x = 0; x < layer.width; ++x) {
            const surfel::Colour c = colour(x, y);
            if ((x > 0 && standsOut(c, colour(x - 1, y))) || (x + 1 < layer.width && standsOut(c, colour(x + 1, y))) ||
                (y > 0 && standsOut(c, colour(x, y - 1))) || (y + 1 < layer.height && standsOut(c, colour(x, y + 1))))
                out.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(layer.width) +
                              static_cast<std::size_t>(x));
        }
    return out;
}

/// Of equal parts of a pixel; what is transparent has no colour.
static surfel::Colour mean(surfel::Colour own, std::span<const ShadedLayer::Pixel> more) {
    unsigned alpha = 0, sum[3] = {};
    const auto add = [&](surfel::Colour c) {
        alpha += c >> 24;
        for (int k = 0; k < 3; ++k)
            sum[k] += (c >> (8 * k) & 255u) * (c >> 24);
    };
    add(own);
    for (const ShadedLayer::Pixel& pixel : more)
        add(pixel.colour);
    if (alpha == 0)
        return own;
    const auto parts = static_cast<unsigned>(more.size() + 1);
    const auto channel = [&](int k) { return (sum[k] + alpha / 2) / alpha; };
    return surfel::rgba(channel(0), channel(1), channel(2), (alpha + parts / 2) / parts);
}

namespace {

/// The same picture with eight times the pixels each way, of which few are asked for.
class FineView {
  public:
    FineView(const surface::Surface& surface, const Camera& camera, const EdgeLook& look)
        : m_surface(surface), m_camera(finer(camera)), m_rays(imageRays(m_camera)), m_view(m_camera), m_look(look) {}

    /// `each` pixels for every pixel of the picture, which is `width` wide.
    std::span<const ShadedLayer::Pixel> show(std::span<const std::size_t> pixels, int width, EdgeCounts& counts,
                                             const base::Progress& progress) {
        m_places.clear();
        for (const std::size_t i : pixels)
            for (const raycast::Pixel& place : places)
                m_places.push_back({fine * (static_cast<int>(i) % width) + place.column,
                                    fine * (static_cast<int>(i) / width) + place.row});
        m_samples.resize(m_places.size());
        castPixels(m_surface, m_rays, m_places, m_samples);
        if (m_look.measured)
            colourHits(*m_look.measured, each, m_samples, {}, progress);
        counts.rays += m_samples.size();
        for (const raycast::Sample& sample : m_samples)
            counts.evaluations += static_cast<std::size_t>(sample.hit.evaluations);
        shade();
        if (m_look.light)
            lightPixels(*m_look.light, seen(), m_pixels, counts.light, progress);
        return m_pixels;
    }

  private:
    static Camera finer(Camera camera) {
        camera.width *= fine, camera.height *= fine;
        return camera;
    }
    void shade() {
        const SampleShade shade = sampleShade(m_look.shading, *m_surface.tree().layout(), m_look.measured != nullptr);
        m_pixels.assign(m_samples.size(), {});
        base::parallelFor(m_samples.size(), 1024, [&](std::size_t i) {
            m_pixels[i].kind = PixelKind::Background;
            if (m_samples[i].hit.hit)
                m_pixels[i] = shadeSample(shade, m_view, m_places[i].column, m_places[i].row, m_samples[i]);
        });
    }
    raycast::SeenSamples seen() const {
        return {m_samples, [this](std::size_t i) { return m_rays.ray(m_places[i].column, m_places[i].row); }};
    }

    cells::AnySurface m_surface;
    Camera m_camera;
    raycast::ImageRays m_rays;
    ViewFrame m_view;
    const EdgeLook& m_look;
    std::vector<raycast::Pixel> m_places;
    std::vector<raycast::Sample> m_samples;
    std::vector<ShadedLayer::Pixel> m_pixels;
};

} // namespace

void smoothEdges(const surface::Surface& surface, const Camera& camera, const EdgeLook& look, ShadedLayer& layer,
                 EdgeCounts& counts, const base::Progress& progress) {
    FineView view(surface, camera, look);
    const std::vector<std::size_t> edges = edgesOf(layer);
    const base::Progress quiet{{}, progress.cancel};
    for (std::size_t begin = 0; begin < edges.size(); begin += batchSize) {
        progress.step(static_cast<double>(begin) / static_cast<double>(edges.size()), "smoothing edges");
        const auto some = std::span(edges).subspan(begin, std::min(batchSize, edges.size() - begin));
        const auto shown = view.show(some, layer.width, counts, quiet);
        for (std::size_t k = 0; k < some.size(); ++k) {
            surfel::Colour& colour = layer.pixels[some[k]].colour;
            colour = mean(colour, shown.subspan(k * each, each));
        }
    }
}

} // namespace render
