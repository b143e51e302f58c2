// Rays of chosen pixels: what fullCast finds there, bit for bit.
#pragma once

#include "core/raycast/full_cast.h"

namespace raycast {

/// A pixel, also one beside the image: columns and rows go on there.
struct Pixel {
    int column = 0, row = 0;
    bool operator==(const Pixel&) const = default;
};

/// In parallel, best when neighbours in the list are neighbours in the image. REQUIRES: pixels.size() == out.size().
void castPixels(const surface::Surface& surface, const ImageRays& view, std::span<const Pixel> pixels,
                std::span<Sample> out);

} // namespace raycast
