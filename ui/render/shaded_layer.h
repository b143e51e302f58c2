// Pixels whose look is known before anything is drawn, such as those of cast rays: the background shows around them,
// or splats where nothing is known yet (CpuSplatter::showOver).
#pragma once

#include "core/raycast/full_cast.h"
#include "ui/render/renderer.h"
#include "ui/render/view_frame.h"

namespace render {

enum class PixelKind : std::uint8_t { Unknown, Surface, Background };

/// Row by row from the top.
struct ShadedLayer {
    struct Pixel {
        PixelKind kind = PixelKind::Unknown;
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

/// Shades samples as splats are shaded; a sample is a pixel of `kind(i)`. In parallel.
ShadedLayer shadeSamples(std::span<const raycast::Sample> samples, const std::function<PixelKind(std::size_t)>& kind,
                         const surfel::AttributeLayout& layout, const Camera& camera, Shading shading);

/// The layer on the background, with effects and grid; unknown pixels are background.
void showLayer(const ShadedLayer& layer, const Camera& camera, const RenderOptions& options, Image& out);

} // namespace render
