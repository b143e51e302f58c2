// The transfer curve of sRGB (IEC 61966-2-1). Channels from 0 to 1.
#pragma once

#include <cmath>

namespace base {

inline float linearOf(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

} // namespace base
