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

void lightPixels(const raycast::LightScene& scene, const raycast::SeenSamples& seen,
                 std::span<ShadedLayer::Pixel> pixels, raycast::LightCounts& counts, const base::Progress& progress) {
    std::vector<raycast::Lit> lit(pixels.size());
    illuminate(scene, seen, lit, counts, progress);
    const bool shaded = scene.lighting.material == raycast::Material::Matcap;
    base::parallelFor(pixels.size(), 4096, [&](std::size_t i) {
        surfel::Colour& colour = pixels[i].colour;
        if (pixels[i].kind == PixelKind::Surface && lit[i].seen == raycast::Seen::Model)
            colour = shaded ? darkened(colour, lit[i].shade) : coloured(lit[i].colour);
        else if (pixels[i].kind == PixelKind::Background && lit[i].seen == raycast::Seen::Ground)
            colour = surfel::rgba(0, 0, 0, static_cast<unsigned>((1 - darkening(lit[i].shade)) * 255 + 0.5f));
    });
}

} // namespace render
