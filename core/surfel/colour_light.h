// Linear light of a colour, for whatever mixes or compares light rather than numbers of a file.
#pragma once

#include "core/base/srgb.h"
#include "core/surfel/surfel.h"

namespace surfel {

/// Red, green and blue, 0 to 1.
inline base::Vec3d lightOf(Colour colour) {
    const auto channel = [&](unsigned c) {
        return static_cast<double>(base::linearOf(static_cast<float>(colour >> 8 * c & 255u) / 255.0f));
    };
    return {channel(0), channel(1), channel(2)};
}

} // namespace surfel
