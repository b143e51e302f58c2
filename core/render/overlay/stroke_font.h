// Letters as strokes of a pen: pictures made without a display have no fonts to ask for, and look the same on every
// machine. ASCII letters, digits and what numbers and units need.
#pragma once

#include <string_view>
#include <vector>

namespace render {

/// Polylines in units of a sixth of the height of capitals, from the base line: x right, y down (capitals at -6 to 0).
struct Glyph {
    struct Point {
        float x, y;
    };
    std::vector<std::vector<Point>> strokes; ///< a single point is a dot
    float advance = 6;                       ///< to the next letter
};

bool hasGlyph(char letter);
/// A box for letters that it lacks.
Glyph glyph(char letter);
/// In pixels.
float textWidth(std::string_view text, float capHeight);

} // namespace render
