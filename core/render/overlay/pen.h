// A round pen on an image: antialiased lines that cover each pixel once, however they join, cross or overlap, so that
// what is translucent is nowhere darker at joints. The same bits on every machine and at any thread count.
#pragma once

#include "core/base/vec.h"
#include "core/render/renderer.h"

#include <functional>
#include <vector>

namespace render {

/// Pixels from the upper left corner of an image; the first pixel's middle is at (0.5, 0.5).
struct ImagePoint {
    float x = 0, y = 0;
};

/// Where the pen goes; a line from a point to itself is a dot.
struct PenLine {
    ImagePoint from, to;
};

/// What becomes of a pixel whose middle is `distance` away from the nearest line. Called from several threads.
using Ink = std::function<surfel::Colour(surfel::Colour under, float distance)>;

/// Inks the pixels nearer than `reach` to one of the lines. Depths stay.
void draw(std::span<const PenLine> lines, float reach, const Ink& ink, Image& out);

/// How much of a pixel a line of that width covers.
float covered(float width, float distance);
/// A colour (sRGB, 0 to 1) over another, not premultiplied.
surfel::Colour inked(surfel::Colour under, const base::Vec3f& colour, float cover);

} // namespace render
