#include "core/render/overlay/annotation_canvas.h"

#include "core/render/overlay/stroke_font.h"

#include <algorithm>
#include <cmath>

namespace render {

using base::Vec3f;

namespace {

struct Canvas {
    Image& image;

    void blend(int x, int y, const Vec3f& colour, float cover) const {
        surfel::Colour& pixel = image.colour[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                             static_cast<std::size_t>(x)];
        const float under = static_cast<float>(pixel >> 24) / 255 * (1 - cover), alpha = cover + under;
        if (!(alpha > 0))
            return;
        surfel::Colour out = static_cast<surfel::Colour>(alpha * 255 + 0.5f) << 24;
        for (std::size_t k = 0; k < 3; ++k) {
            const float old = static_cast<float>(pixel >> (8 * k) & 255u);
            out |= static_cast<surfel::Colour>((255 * colour[k] * cover + old * under) / alpha + 0.5f) << (8 * k);
        }
        pixel = out;
    }
};

/// The pen's track: how near a pixel's centre is to one of its pieces.
struct Track {
    std::vector<std::pair<Place, Place>> pieces;

    float distance(float x, float y) const {
        float nearest = std::numeric_limits<float>::infinity();
        for (const auto& [a, b] : pieces) {
            const float dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
            const float t = length > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length, 0.0f, 1.0f) : 0;
            nearest = std::min(nearest, std::hypot(x - a.x - t * dx, y - a.y - t * dy));
        }
        return nearest;
    }
};

/// Each pixel once, however the pieces overlap: first the rim, then the pen.
void draw(const Canvas& canvas, const Track& track, float width, const Vec3f& colour) {
    if (track.pieces.empty())
        return;
    const bool light = colour.x + colour.y + colour.z > 1.2f;
    const Vec3f rim = light ? Vec3f{0.05f, 0.05f, 0.06f} : Vec3f{1, 1, 1};
    const float soft = 1.4f * std::max(1.0f, 0.6f * width), reach = 0.5f * width + soft + 1;
    Place low = track.pieces.front().first, high = low;
    for (const auto& [a, b] : track.pieces)
        for (const Place& p : {a, b}) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    const auto pixel = [](float value, int end) { return static_cast<int>(std::clamp(value, 0.0f, float(end))); };
    for (int y = pixel(low.y - reach, canvas.image.height); y < pixel(high.y + reach + 1, canvas.image.height); ++y)
        for (int x = pixel(low.x - reach, canvas.image.width); x < pixel(high.x + reach + 1, canvas.image.width); ++x) {
            const float away = track.distance(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float halo = std::clamp(1 - (away - 0.5f * width) / soft, 0.0f, 1.0f);
            if (halo > 0)
                canvas.blend(x, y, rim, 0.4f * halo);
            const float cover = std::clamp(0.5f + 0.5f * width - away, 0.0f, 1.0f);
            if (cover > 0)
                canvas.blend(x, y, colour, cover);
        }
}

void draw(const Canvas& canvas, const DrawnText& text) {
    const float unit = text.capHeight / 6;
    float x = text.at.x - text.anchor * textWidth(text.text, text.capHeight);
    Track track;
    for (const char letter : text.text) {
        const Glyph shape = glyph(letter);
        for (const auto& stroke : shape.strokes)
            for (std::size_t k = 0; k < stroke.size(); ++k) {
                const auto place = [&](std::size_t i) {
                    return Place{x + stroke[i].x * unit, text.at.y + stroke[i].y * unit};
                };
                if (k > 0 || stroke.size() == 1)
                    track.pieces.emplace_back(place(k > 0 ? k - 1 : k), place(k));
            }
        x += shape.advance * unit;
    }
    draw(canvas, track, std::max(1.1f, 0.75f * unit), text.colour);
}

void draw(const Canvas& canvas, const DrawnRamp& ramp) {
    const auto column = [&](float x) { return std::clamp(static_cast<int>(std::lround(x)), 0, canvas.image.width); };
    const int top = static_cast<int>(std::lround(ramp.corner.y)), tall = static_cast<int>(std::lround(ramp.height));
    for (int row = 0; row < tall; ++row) {
        const int y = top + row;
        if (y < 0 || y >= canvas.image.height)
            continue;
        const surfel::Colour c = mapped(ramp.map, 1 - (static_cast<float>(row) + 0.5f) / static_cast<float>(tall));
        for (int x = column(ramp.corner.x); x < column(ramp.corner.x + ramp.width); ++x)
            canvas.image.colour[static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.image.width) +
                                static_cast<std::size_t>(x)] = c;
    }
}

} // namespace

void paint(const Drawing& drawing, Image& out) {
    const Canvas canvas{out};
    for (const DrawnRamp& ramp : drawing.ramps)
        draw(canvas, ramp);
    for (const DrawnLine& line : drawing.lines)
        draw(canvas, Track{{{line.from, line.to}}}, line.width, line.colour);
    for (const DrawnText& text : drawing.texts)
        draw(canvas, text);
}

} // namespace render
