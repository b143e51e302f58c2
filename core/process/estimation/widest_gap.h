// The widest sector, as seen from a place, in which nothing lies. Internal to the room.
#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

namespace process {

/// Between directions around a place, in radians; 2 pi where there is none. Sorts them.
inline float widestGap(std::vector<float>& angles) {
    constexpr float pi = std::numbers::pi_v<float>;
    if (angles.empty())
        return 2 * pi;
    std::sort(angles.begin(), angles.end());
    float gap = angles.front() + 2 * pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
        gap = std::max(gap, angles[i] - angles[i - 1]);
    return gap;
}

} // namespace process
