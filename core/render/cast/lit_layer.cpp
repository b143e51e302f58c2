#include "core/render/cast/lit_layer.h"

#include "core/base/parallel.h"
#include "core/base/srgb.h"
#include "core/render/shading/light_terms.h"

namespace render {

using base::Vec3f;

/// The inverse of light::encode for a channel of the background.
static float decode(float srgb) {
    const float c = base::linearOf(srgb);
    const float shoulder = 0.18f * c; // c = x / (1 + 0.18 x^2)
    return 2 * c / (1 + std::sqrt(std::max(0.0f, 1 - 4 * shoulder * c)));
}
static Vec3f decode(const Vec3f& c) {
    return {decode(c.x), decode(c.y), decode(c.z)};
}

raycast::Viewer viewerOf(const Camera& camera, const RenderOptions& options) {
    const BackdropRow& row = backdropRow(options.backdrop);
    raycast::Viewer out;
    out.forward = base::cast<float>(camera.forward());
    out.upright = base::cast<float>(camera.upright());
    out.up = base::cast<float>(normalized(camera.up, {0, 1, 0}));
    constexpr float usualSlope = 0.3f; // parallel rays see one place of the background only
    out.slope = camera.parallel() ? usualSlope : static_cast<float>(0.5 * camera.height / camera.focalPx());
    out.top = decode(row.top), out.bottom = decode(row.bottom);
    return out;
}

static surfel::Colour coloured(const Vec3f& light) {
    constexpr float brightest = 2.3f; // where the shoulder of light::encode is highest
    const auto byte = [&](float c) {
        return static_cast<unsigned>(light::encode(std::min(c, brightest)) * 255 + 0.5f);
    };
    return surfel::rgba(byte(light.x), byte(light.y), byte(light.z));
}

/// A colour in less light: `shade` is a part of linear light, sRGB is nearly its root.
static float darkening(float shade) {
    return std::pow(std::clamp(shade, 0.0f, 1.0f), 1 / 2.2f);
}

static surfel::Colour darkened(surfel::Colour colour, float shade) {
    const float factor = darkening(shade);
    const auto channel = [&](int k) {
        return static_cast<unsigned>(static_cast<float>(colour >> k & 255u) * factor + 0.5f);
    };
    return surfel::rgba(channel(0), channel(8), channel(16), colour >> 24);
}

/// One pixel in the light that was found for it, or for one near to it.
static void take(const raycast::Lit& lit, bool shaded, ShadedLayer::Pixel& pixel) {
    if (pixel.kind == PixelKind::Surface && lit.seen == raycast::Seen::Model)
        pixel.colour = shaded ? darkened(pixel.colour, lit.shade) : coloured(lit.colour);
    else if (pixel.kind == PixelKind::Background && lit.seen == raycast::Seen::Ground)
        pixel.colour = surfel::rgba(0, 0, 0, static_cast<unsigned>((1 - darkening(lit.shade)) * 255 + 0.5f));
}

void lightPixels(const raycast::LightScene& scene, const raycast::SeenSamples& seen,
                 std::span<ShadedLayer::Pixel> pixels, raycast::LightCounts& counts, const base::Progress& progress) {
    std::vector<raycast::Lit> lit(pixels.size());
    illuminate(scene, seen, lit, counts, progress);
    const bool shaded = scene.lighting.material == raycast::Material::Matcap;
    base::parallelFor(pixels.size(), 4096, [&](std::size_t i) { take(lit[i], shaded, pixels[i]); });
}

/// Do both show one part of the surface, so that light is alike on them?
static bool alike(const ShadedLayer::Pixel& a, const ShadedLayer::Pixel& b) {
    constexpr float sameSide = 0.8f, sameDepth = 0.05f; // cosine, part of the depth
    return a.kind == b.kind && (a.kind != PixelKind::Surface || (dot(a.normal, b.normal) > sameSide &&
                                                                 std::abs(a.depth - b.depth) < sameDepth * a.depth));
}

void lightCoarsely(const raycast::LightScene& scene, const raycast::ImageRays& rays,
                   std::span<const raycast::Sample> samples, int stride, ShadedLayer& layer,
                   const base::Progress& progress) {
    const int columns = (layer.width + stride - 1) / stride, rows = (layer.height + stride - 1) / stride;
    // The pixel in the middle of each square, as far as the image goes.
    const auto middle = [&](int column, int row) {
        return std::pair(std::min(column * stride + stride / 2, layer.width - 1),
                         std::min(row * stride + stride / 2, layer.height - 1));
    };
    std::vector<raycast::Sample> some;
    some.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto [x, y] = middle(column, row);
            some.push_back(samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(layer.width) +
                                   static_cast<std::size_t>(x)]);
        }
    const auto ray = [&](std::size_t i) {
        const auto [x, y] = middle(static_cast<int>(i) % columns, static_cast<int>(i) / columns);
        return rays.ray(x, y);
    };
    std::vector<raycast::Lit> lit(some.size());
    raycast::LightCounts counts;
    illuminate(scene, {some, ray, columns}, lit, counts, progress);
    const bool shaded = scene.lighting.material == raycast::Material::Matcap;
    const ShadedLayer before = layer;
    base::parallelFor(static_cast<std::size_t>(layer.height), 16, [&](std::size_t line) {
        const int y = static_cast<int>(line);
        for (int x = 0; x < layer.width; ++x) {
            const int column = x / stride, row = y / stride;
            const auto [mx, my] = middle(column, row);
            if (alike(before.row(y)[x], before.row(my)[mx]))
                take(lit[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(column)],
                     shaded, layer.row(y)[x]);
        }
    });
}

} // namespace render
