#include "core/render/shading/shading.h"

#include "core/base/parallel.h"

#include <array>
#include <mutex>

namespace render {

using base::Vec3f;

static unsigned byteOf(float value) {
    return static_cast<unsigned>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f);
}

/// The picture of a ball under `light`; outside its outline the outline's own colour goes on.
static std::vector<surfel::Colour> ball(Vec3f (*light)(const Vec3f&)) {
    std::vector<surfel::Colour> out(std::size_t(lightSize) * lightSize);
    base::parallelFor(lightSize, 16, [&](std::size_t row) {
        for (std::size_t column = 0; column < lightSize; ++column) {
            Vec3f n{2 * static_cast<float>(column) / (lightSize - 1) - 1,
                    1 - 2 * static_cast<float>(row) / (lightSize - 1), 0};
            const float inPlane = n.x * n.x + n.y * n.y;
            n = inPlane < 1 ? Vec3f{n.x, n.y, std::sqrt(1 - inPlane)} : normalized(n);
            const Vec3f c = light(n);
            out[row * lightSize + column] = surfel::rgba(byteOf(c.x), byteOf(c.y), byteOf(c.z));
        }
    });
    return out;
}

const ShadingStyle& shadingStyle(Shading shading) {
    // Each on its own: a window that only ever shows clay must not wait for the other pictures at its start.
    constexpr std::size_t most = 32;
    static std::array<std::once_flag, most> made;
    static std::array<ShadingStyle, most> styles;
    const auto at = static_cast<std::size_t>(shading);
    std::call_once(made[at], [&] {
        const ShadingRow& row = shadingRow(shading);
        styles[at] = {ball(row.light), row.usesColour(), row.maskTint, row.backTint};
    });
    return styles[at];
}

surfel::Colour shade(Shading shading, const Vec3f& normal, surfel::Colour colour, float mask) {
    const ShadingStyle& style = shadingStyle(shading);
    return shadePixel(style, normal, style.usesColour ? colour : surfel::white, mask);
}

} // namespace render
