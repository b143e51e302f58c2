#include "ui/render/raycast_image.h"

#include "core/base/parallel.h"
#include "ui/render/finish.h"
#include "ui/render/shading.h"
#include "ui/render/view_frame.h"

namespace render {

using base::Vec3d;
using base::Vec3f;

/// REQUIRES: the camera outlives the result.
static raycast::ImageRays imageRays(const Camera& camera) {
    const Vec3d right = camera.right(), down = -camera.upright(), forward = camera.forward();
    const Vec3d aside = right * (0.5 - 0.5 * camera.width) + down * (0.5 - 0.5 * camera.height);
    raycast::ImageRays out;
    out.width = camera.width, out.height = camera.height;
    out.clips = camera.clips.all();
    if (camera.parallel()) {
        const double unit = 1 / camera.focalPx();
        out.eye = camera.eye + aside * unit;
        out.originAcross = right * unit, out.originDown = down * unit;
        out.corner = forward;
    } else {
        out.eye = camera.eye;
        out.corner = forward * camera.focalPx() + aside;
        out.across = right, out.down = down;
    }
    return out;
}

/// Pixels asked for together, in squares: neighbours in the list are neighbours in space.
constexpr int squareSide = 128;

/// Colours of the measured numbers where the rays met the surface.
static void colourHits(const Measured& measured, const Camera& camera, std::vector<raycast::Sample>& samples,
                       const base::Progress& progress) {
    std::vector<std::size_t> pixels;
    std::vector<Vec3f> x;
    std::vector<float> values;
    const auto ask = [&](int left, int top) {
        pixels.clear(), x.clear();
        for (int row = top; row < std::min(top + squareSide, camera.height); ++row)
            for (int column = left; column < std::min(left + squareSide, camera.width); ++column) {
                const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) +
                               static_cast<std::size_t>(column);
                if (!samples[i].hit.hit)
                    continue;
                pixels.push_back(i);
                x.push_back(samples[i].hit.position);
            }
        values.resize(x.size());
        process::quantityAt(measured.question, x, values);
        for (std::size_t k = 0; k < pixels.size(); ++k)
            samples[pixels[k]].colour = measured.scale.of(values[k]);
    };
    for (int top = 0; top < camera.height; top += squareSide)
        for (int left = 0; left < camera.width; left += squareSide) {
            progress.step(static_cast<double>(top) / camera.height, "Measuring the surface");
            ask(left, top);
        }
}

void rayCast(const surface::Surface& surface, const Camera& camera, const RenderOptions& options, Image& out,
             raycast::CastCounts& counts, const base::Progress& progress, const Measured* measured) {
    auto samples = raycast::fullCast(surface, imageRays(camera), counts, progress);
    if (measured)
        colourHits(*measured, camera, samples, progress);
    const ViewFrame view(camera);
    const ShadingStyle& style = shadingStyle(options.shading);
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    const bool oriented = layout.normals && layout.oriented;
    out.resize(camera.width, camera.height);
    Finish finish;
    finish.begin(options, camera);
    base::parallelFor(static_cast<std::size_t>(camera.height), 8, [&](std::size_t y) {
        surfel::Colour background[8];
        backgroundRow(options.backdrop, static_cast<int>(y), camera.height, options.transparent, background);
        const float dy = -view.raySlopeY(static_cast<int>(y));
        for (std::size_t x = 0; x < static_cast<std::size_t>(camera.width); ++x) {
            const std::size_t i = y * static_cast<std::size_t>(camera.width) + x;
            const raycast::Sample& sample = samples[i];
            out.colour[i] = background[x & 7];
            if (!sample.hit.hit) {
                if (finish.wanted())
                    finish.set(static_cast<int>(x), static_cast<int>(y), out.colour[i], nowhereOf(view), {});
                continue;
            }
            const Vec3f turned = view.turn(oriented ? sample.hit.outward : sample.hit.normal);
            const Vec3f normal = inRayFrame({turned.x, -turned.y, -turned.z}, view.raySlopeX(static_cast<int>(x)), dy);
            out.colour[i] = shadePixel(style, normal, sample.colour, sample.mask);
            out.depth[i] = sample.hit.t;
            if (finish.wanted()) {
                const float dx = view.raySlopeX(static_cast<int>(x));
                const float z = sample.hit.t / std::sqrt(dx * dx + dy * dy + 1);
                finish.set(static_cast<int>(x), static_cast<int>(y), out.colour[i], view.nearness(z),
                           {turned.x, -turned.y, -turned.z});
            }
        }
    });
    if (finish.wanted()) {
        TileMask all(view);
        all.add({true, 0, 0, camera.width - 1, camera.height - 1, 0});
        finish.tiles(all, out);
    }
}

} // namespace render
