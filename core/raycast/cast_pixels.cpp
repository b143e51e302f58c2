#include "core/raycast/cast_pixels.h"

#include <cassert>

namespace raycast {

void castPixels(const cells::AnySurface& surface, const ImageRays& view, std::span<const Pixel> pixels,
                std::span<Sample> out) {
    assert(pixels.size() == out.size());
    std::fill(out.begin(), out.end(), Sample{});
    castEach(surface, view, pixels, [&](std::size_t i) -> Sample& { return out[i]; });
}

} // namespace raycast
