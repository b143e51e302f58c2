// The way of a hand or a tool: places in time.
#pragma once

#include "core/base/vec.h"

#include <vector>

namespace haptics {

struct TimedPlace {
    double time = 0; ///< seconds
    base::Vec3d place;
};
using Trajectory = std::vector<TimedPlace>;

/// Throws base::Error unless it has places, all within what float can hold, at ascending times.
void requireValid(const Trajectory& trajectory);
/// Where it is at a time, on straight lines between its places; at rest before and after. REQUIRES: valid.
base::Vec3d placeAt(const Trajectory& trajectory, double time);

} // namespace haptics
