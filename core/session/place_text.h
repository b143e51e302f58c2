// A place as messages tell it: to a hundredth of what lies there, wherever on earth it is.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace session {

/// "1000000.95 12.00 -3.10" of a loop of length 2. `size` in the same unit.
inline std::string placeText(const base::Vec3d& place, double size) {
    std::ostringstream out;
    const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(size, 1e-9)))), 0, 9);
    const double unit = std::pow(10.0, -digits);
    const auto plain = [&](double v) { return std::abs(v) < unit / 2 ? 0.0 : v; }; // no -0.00
    out.precision(digits);
    out << std::fixed << plain(place.x) << ' ' << plain(place.y) << ' ' << plain(place.z);
    return out.str();
}

} // namespace session
