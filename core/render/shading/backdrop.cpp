#include "core/render/shading/backdrop.h"

#include "core/base/row_of_id.h"

#include <algorithm>
#include <string>

namespace render {

using base::Vec3f;

std::span<const BackdropRow> backdropTable() {
    static const Vec3f light{0.88f, 0.89f, 0.9f}, dark{0.12f, 0.13f, 0.15f};
    static const BackdropRow rows[] = {
        {Backdrop::Studio,
         "studio",
         "Studio",
         "Cool dark grey, lighter towards the floor",
         {0.165f, 0.178f, 0.2f},
         {0.365f, 0.375f, 0.39f},
         light},
        {Backdrop::Plain,
         "plain",
         "Plain Grey",
         "One grey that favours no colour",
         {0.32f, 0.32f, 0.325f},
         {0.32f, 0.32f, 0.325f},
         light},
        {Backdrop::Dark,
         "dark",
         "Dark",
         "Nearly black, for slides",
         {0.055f, 0.058f, 0.065f},
         {0.095f, 0.1f, 0.11f},
         light},
        {Backdrop::White, "white", "White", "For print", {1, 1, 1}, {1, 1, 1}, dark},
        {Backdrop::Paper,
         "paper",
         "Paper",
         "Warm drawing paper, for lines and soft shadows",
         {0.965f, 0.95f, 0.915f},
         {0.9f, 0.875f, 0.83f},
         dark},
    };
    return rows;
}

const BackdropRow& backdropRow(Backdrop backdrop) {
    return backdropTable()[static_cast<std::size_t>(backdrop)];
}

Backdrop backdrop(std::string_view id) {
    return base::rowOf(backdropTable(), id, {"unknown background '%'", "", "use one of: %"}).backdrop;
}

static Vec3f lightAt(Backdrop backdrop, float height) {
    const BackdropRow& row = backdropRow(backdrop);
    const float t = height * height * (3 - 2 * height);
    return row.top * (1 - t) + row.bottom * t;
}

surfel::Colour background(Backdrop backdrop, float height) {
    const Vec3f c = lightAt(backdrop, std::clamp(height, 0.0f, 1.0f)) * 255;
    const auto byte = [](float value) { return static_cast<unsigned>(std::clamp(value, 0.0f, 255.0f) + 0.5f); };
    return surfel::rgba(byte(c.x), byte(c.y), byte(c.z));
}

void backgroundRow(Backdrop backdrop, int row, int height, bool transparent, surfel::Colour out[8]) {
    // Bayer's 8x8 thresholds by interleaving the bits of (x ^ y, y).
    const Vec3f c = lightAt(backdrop, (static_cast<float>(row) + 0.5f) / static_cast<float>(height)) * 255;
    for (unsigned x = 0; x < 8; ++x) {
        const unsigned y = static_cast<unsigned>(row) & 7, e = x ^ y;
        const unsigned rank = (e & 1) << 5 | (y & 1) << 4 | (e & 2) << 2 | (y & 2) << 1 | (e & 4) >> 1 | (y & 4) >> 2;
        const float threshold = (static_cast<float>(rank) + 0.5f) / 64;
        const auto byte = [&](float value) { return std::min(static_cast<unsigned>(value + threshold), 255u); };
        out[x] = surfel::rgba(byte(c.x), byte(c.y), byte(c.z), transparent ? 0 : 255);
    }
}

} // namespace render
