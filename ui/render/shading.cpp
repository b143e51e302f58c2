#include "ui/render/shading.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "ui/render/light_ball.h"

#include <array>
#include <string>

namespace render {

using base::Vec3f;

static constexpr ShadingRow rows[] = {
    {Shading::Matcap, "matcap", "Clay", "Neutral clay in studio light; protected places are darker"},
    {Shading::Normal, "normal", "Normals", "Direction of the surface as seen from the eye"},
    {Shading::Colour, "colour", "Colour", "Colours of the surfels in plain light"},
    {Shading::Mask, "mask", "Mask", "What is protected from tools, in blue"},
};

std::span<const ShadingRow> shadingTable() {
    return rows;
}

Shading shading(std::string_view id) {
    std::string known;
    for (const ShadingRow& row : rows) {
        if (row.id == id)
            return row.shading;
        known += (known.empty() ? "" : ", ") + std::string(row.id);
    }
    throw base::Error("unknown shading '" + std::string(id) + "'", "", "use one of: " + known);
}

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

static ShadingStyle makeStyle(Shading shading) {
    switch (shading) {
    case Shading::Normal:
        return {ball(normalColour), false, {1, 1, 1}, {0.7f, 0.7f, 0.7f}};
    case Shading::Colour:
        return {ball(plainLight), true, {0.55f, 0.53f, 0.53f}, {0.62f, 0.6f, 0.6f}};
    case Shading::Mask:
        return {ball(clayLight), false, {0.24f, 0.38f, 0.62f}, {0.58f, 0.5f, 0.46f}};
    case Shading::Matcap:
        break;
    }
    return {ball(clayLight), false, {0.5f, 0.47f, 0.46f}, {0.58f, 0.5f, 0.46f}};
}

const ShadingStyle& shadingStyle(Shading shading) {
    // Separate statics: a window that only ever shows clay must not wait for the other tables at its start.
    switch (shading) {
    case Shading::Normal: {
        static const ShadingStyle style = makeStyle(Shading::Normal);
        return style;
    }
    case Shading::Colour: {
        static const ShadingStyle style = makeStyle(Shading::Colour);
        return style;
    }
    case Shading::Mask: {
        static const ShadingStyle style = makeStyle(Shading::Mask);
        return style;
    }
    case Shading::Matcap:
        break;
    }
    static const ShadingStyle style = makeStyle(Shading::Matcap);
    return style;
}

surfel::Colour shade(Shading shading, const Vec3f& normal, surfel::Colour colour, float mask) {
    return shadePixel(shadingStyle(shading), normal, colour, mask);
}

/// Cool dark grey, lighter towards the floor, where a model's shaded side stands before it.
static Vec3f backgroundLight(float height) {
    const float t = height * height * (3 - 2 * height);
    return Vec3f{0.165f, 0.178f, 0.2f} * (1 - t) + Vec3f{0.365f, 0.375f, 0.39f} * t;
}

surfel::Colour background(float height) {
    const Vec3f c = backgroundLight(std::clamp(height, 0.0f, 1.0f));
    return surfel::rgba(byteOf(c.x), byteOf(c.y), byteOf(c.z));
}

void backgroundRow(int row, int height, bool transparent, surfel::Colour out[8]) {
    // Bayer's 8x8 thresholds by interleaving the bits of (x ^ y, y).
    const Vec3f c = backgroundLight((static_cast<float>(row) + 0.5f) / static_cast<float>(height)) * 255;
    for (unsigned x = 0; x < 8; ++x) {
        const unsigned y = static_cast<unsigned>(row) & 7, e = x ^ y;
        const unsigned rank = (e & 1) << 5 | (y & 1) << 4 | (e & 2) << 2 | (y & 2) << 1 | (e & 4) >> 1 | (y & 4) >> 2;
        const float threshold = (static_cast<float>(rank) + 0.5f) / 64;
        out[x] = surfel::rgba(static_cast<unsigned>(c.x + threshold), static_cast<unsigned>(c.y + threshold),
                              static_cast<unsigned>(c.z + threshold), transparent ? 0 : 255);
    }
}

} // namespace render
