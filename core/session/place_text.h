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
    out.precision(std::clamp(2 - static_cast<int>(std::floor(std::log10(std::max(size, 1e-9)))), 0, 9));
    out << std::fixed << place.x << ' ' << place.y << ' ' << place.z;
    return out.str();
}

} // namespace session
