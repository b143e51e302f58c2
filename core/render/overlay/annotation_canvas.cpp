#include "core/render/overlay/annotation_canvas.h"

#include "core/render/overlay/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {

using base::Vec3f;

namespace {

/// First a soft edge of the opposite lightness, then the pen.
void write(std::span<const PenLine> lines, float width, const Vec3f& colour, Image& out) {
    const bool light = colour.x + colour.y + colour.z > 1.2f;
    const Vec3f edge = light ? Vec3f{0.05f, 0.05f, 0.06f} : Vec3f{1, 1, 1};
    const float soft = 1.4f * std::max(1.0f, 0.6f * width);
    const auto ink = [&](surfel::Colour pixel, float away) {
        const float halo = std::clamp(1 - (away - 0.5f * width) / soft, 0.0f, 1.0f), cover = covered(width, away);
        if (halo > 0)
            pixel = inked(pixel, edge, 0.4f * halo);
        return cover > 0 ? inked(pixel, colour, cover) : pixel;
    };
    draw(lines, 0.5f * width + soft + 1, ink, out);
}

void write(const DrawnText& text, Image& out) {
    const float unit = text.capHeight / 6;
    float x = text.at.x - text.anchor * textWidth(text.text, text.capHeight);
    std::vector<PenLine> lines;
    for (const char letter : text.text) {
        const Glyph shape = glyph(letter);
        for (const auto& stroke : shape.strokes)
            for (std::size_t k = 0; k < stroke.size(); ++k) {
                const auto place = [&](std::size_t i) {
                    return ImagePoint{x + stroke[i].x * unit, text.at.y + stroke[i].y * unit};
                };
                if (k > 0 || stroke.size() == 1)
                    lines.push_back({place(k > 0 ? k - 1 : k), place(k)});
            }
        x += shape.advance * unit;
    }
    write(lines, std::max(1.1f, 0.75f * unit), text.colour, out);
}

void fill(const DrawnRamp& ramp, Image& out) {
    const auto column = [&](float x) { return std::clamp(static_cast<int>(std::lround(x)), 0, out.width); };
    const int top = static_cast<int>(std::lround(ramp.corner.y)), tall = static_cast<int>(std::lround(ramp.height));
    for (int row = 0; row < tall; ++row) {
        const int y = top + row;
        if (y < 0 || y >= out.height)
            continue;
        const surfel::Colour c = mapped(ramp.map, 1 - (static_cast<float>(row) + 0.5f) / static_cast<float>(tall));
        for (int x = column(ramp.corner.x); x < column(ramp.corner.x + ramp.width); ++x)
            out.colour[static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) +
                       static_cast<std::size_t>(x)] = c;
    }
}

} // namespace

void paint(const Drawing& drawing, Image& out) {
    for (const DrawnRamp& ramp : drawing.ramps)
        fill(ramp, out);
    for (const DrawnLine& line : drawing.lines)
        write(std::array{PenLine{line.from, line.to}}, line.width, line.colour, out);
    for (const DrawnText& text : drawing.texts)
        write(text, out);
}

} // namespace render
