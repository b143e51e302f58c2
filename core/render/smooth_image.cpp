#include "core/render/smooth_image.h"

namespace render {

/// Mean of four pixels; the colour of a transparent one does not count.
static surfel::Colour mean(const surfel::Colour (&four)[4]) {
    unsigned alpha = 0, sum[3] = {};
    for (const surfel::Colour c : four) {
        alpha += c >> 24;
        for (int k = 0; k < 3; ++k)
            sum[k] += (c >> (8 * k) & 255u) * (c >> 24);
    }
    if (alpha == 0)
        return four[0];
    const auto channel = [&](int k) { return (sum[k] + alpha / 2) / alpha; };
    return surfel::rgba(channel(0), channel(1), channel(2), (alpha + 2) / 4);
}

void shrink(const Image& fine, Image& out) {
    const auto width = static_cast<std::size_t>(out.width);
    for (std::size_t i = 0; i < out.colour.size(); ++i) {
        const surfel::Colour* c = fine.colour.data() + i / width * 4 * width + i % width * 2;
        out.colour[i] = mean({c[0], c[1], c[2 * width], c[2 * width + 1]});
    }
}

void renderSmooth(const Camera& camera, const std::function<void(const Camera&, Image&)>& draw, Image& out) {
    Camera twice = camera;
    twice.width *= 2;
    twice.height *= 2;
    Image fine;
    draw(twice, fine);
    draw(camera, out);
    shrink(fine, out);
}

void renderSmooth(Renderer& renderer, const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options,
                  Image& out) {
    renderSmooth(
        camera,
        [&](const Camera& view, Image& image) {
            RenderOptions scaled = options;
            scaled.pixelScale *= static_cast<float>(view.width) / static_cast<float>(camera.width);
            renderer.render(model, view, scaled, image);
        },
        out);
}

} // namespace render
