// Pixels whose look is known before anything is drawn, such as those of cast rays: the background shows around them,
// or splats where nothing is known yet (CpuSplatter::showOver).
#pragma once

#include "core/raycast/full_cast.h"
#include "core/render/shading/shading.h"
#include "core/render/view_frame.h"

namespace render {

enum class PixelKind : std::uint8_t { Unknown, Surface, Background };

/// Row by row from the top.
struct ShadedLayer {
    struct Pixel {
        PixelKind kind = PixelKind::Unknown;
        /// Of background too: its alpha is the part that shadows on the ground or half-covered edges hide.
        surfel::Colour colour = 0;
        float depth = 0;    ///< along the pixel's ray
        base::Vec3f normal; ///< in camera coordinates: x right, y up, z towards the eye
        bool operator==(const Pixel&) const = default;
    };
    int width = 0, height = 0;
    std::vector<Pixel> pixels;

    ShadedLayer() = default;
    ShadedLayer(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    Pixel* row(int y) { return pixels.data() + static_cast<std::ptrdiff_t>(y) * width; }
    const Pixel* row(int y) const { return pixels.data() + static_cast<std::ptrdiff_t>(y) * width; }
};

/// Distance along `forward` of what a pixel's ray meets after `depth`.
inline float forwardDepth(const ViewFrame& view, int column, int row, float depth) {
    const float dx = view.raySlopeX(column), dy = view.raySlopeY(row);
    return depth / std::sqrt(dx * dx + dy * dy + 1);
}

/// A colour with alpha over another; neither is premultiplied.
inline surfel::Colour over(surfel::Colour above, surfel::Colour below) {
    const unsigned a = above >> 24, rest = (255 - a) * (below >> 24), alpha = a * 255 + rest; // of 255^2
    if (a == 255 || alpha == 0)
        return above;
    const auto channel = [&](int k) {
        return ((above >> k & 255u) * a * 255 + (below >> k & 255u) * rest + alpha / 2) / alpha;
    };
    return surfel::rgba(channel(0), channel(8), channel(16), (alpha + 127) / 255);
}

/// How samples of a model are shaded.
struct SampleShade {
    const ShadingStyle& style;
    bool oriented, coloured; ///< not coloured: whatever their colours are
};
/// `measured`: their colours are those of colourHits, which any shading shows.
SampleShade sampleShade(Shading shading, const surfel::AttributeLayout& layout, bool measured);

/// One sample as splats are shaded, seen at a pixel of the view.
ShadedLayer::Pixel shadeSample(const SampleShade& shade, const ViewFrame& view, int column, int row,
                               const raycast::Sample& sample);
/// Shades samples as splats are shaded; a sample is a pixel of `kind(i)`. In parallel.
ShadedLayer shadeSamples(std::span<const raycast::Sample> samples, const std::function<PixelKind(std::size_t)>& kind,
                         const SampleShade& shade, const Camera& camera);

/// The layer on the background, with effects and grid; unknown pixels are background.
void showLayer(const ShadedLayer& layer, const Camera& camera, const RenderOptions& options, Image& out);

} // namespace render
