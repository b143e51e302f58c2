#include "core/render/shaded_layer.h"

#include "core/base/parallel.h"
#include "core/render/effects/finish.h"
#include "core/render/shading/shading.h"

namespace render {

using base::Vec3f;

constexpr std::size_t rowsPerChunk = 8;

SampleShade sampleShade(Shading shading, const surfel::AttributeLayout& layout, bool measured) {
    const ShadingStyle& style = shadingStyle(shading);
    return {style, layout.normals && layout.oriented, style.usesColour || measured};
}

ShadedLayer::Pixel shadeSample(const SampleShade& shade, const ViewFrame& view, int column, int row,
                               const raycast::Sample& sample) {
    ShadedLayer::Pixel pixel;
    pixel.kind = PixelKind::Surface;
    const Vec3f turned = view.turn(shade.oriented ? sample.hit.outward : sample.hit.normal);
    pixel.normal = {turned.x, -turned.y, -turned.z};
    const Vec3f seen = inRayFrame(pixel.normal, view.raySlopeX(column), -view.raySlopeY(row));
    pixel.colour = shadePixel(shade.style, seen, shade.coloured ? sample.colour : surfel::white, sample.mask);
    pixel.depth = sample.hit.t;
    return pixel;
}

ShadedLayer shadeSamples(std::span<const raycast::Sample> samples, const std::function<PixelKind(std::size_t)>& kind,
                         const SampleShade& shade, const Camera& camera) {
    const ViewFrame view(camera);
    ShadedLayer out(camera.width, camera.height);
    base::parallelFor(static_cast<std::size_t>(camera.height), rowsPerChunk, [&](std::size_t y) {
        const int row = static_cast<int>(y);
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t i = y * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(x);
            out.pixels[i].kind = kind(i);
            if (out.pixels[i].kind == PixelKind::Surface)
                out.pixels[i] = shadeSample(shade, view, x, row, samples[i]);
        }
    });
    return out;
}

void showLayer(const ShadedLayer& layer, const Camera& camera, const RenderOptions& options, Image& out) {
    const ViewFrame view(camera);
    out.resize(camera.width, camera.height);
    Finish finish;
    finish.begin(options, camera);
    base::parallelFor(static_cast<std::size_t>(camera.height), rowsPerChunk, [&](std::size_t y) {
        const int row = static_cast<int>(y);
        surfel::Colour background[8];
        backgroundRow(options.backdrop, row, camera.height, options.transparent, background);
        for (int x = 0; x < camera.width; ++x) {
            const std::size_t i = y * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(x);
            const ShadedLayer::Pixel& pixel = layer.pixels[i];
            const bool surface = pixel.kind == PixelKind::Surface;
            out.colour[i] = over(pixel.colour, background[x & 7]);
            if (surface)
                out.depth[i] = pixel.depth;
            if (finish.wanted())
                finish.set(x, row, out.colour[i],
                           surface ? view.nearness(forwardDepth(view, x, row, pixel.depth)) : nowhereOf(view),
                           surface ? pixel.normal : Vec3f{});
        }
    });
    if (finish.wanted()) {
        TileMask all(view);
        all.add({true, 0, 0, camera.width - 1, camera.height - 1, 0});
        finish.tiles(all, out);
    }
}

} // namespace render
