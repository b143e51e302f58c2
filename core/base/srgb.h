// The transfer curve of sRGB (IEC 61966-2-1). Channels from 0 to 1.
#pragma once

#include <cmath>

namespace base {

inline float linearOf(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

/// The way back.
inline double srgbOf(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

} // namespace base
