#include "core/haptics/trajectory.h"

#include "core/base/error.h"

#include <algorithm>

namespace haptics {

void requireValid(const Trajectory& trajectory) {
    if (trajectory.empty())
        throw base::Error("the trajectory has no places", "", "give at least one");
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        const auto place = [&] { return "place " + std::to_string(i) + " of the trajectory"; };
        if (!isFinite(base::cast<float>(trajectory[i].place)) || !std::isfinite(trajectory[i].time))
            throw base::Error(place() + " is farther away than numbers reach");
        if (i > 0 && !(trajectory[i].time > trajectory[i - 1].time))
            throw base::Error(place() + " is not later than the one before", "", "times must ascend");
    }
}

base::Vec3d placeAt(const Trajectory& trajectory, double time) {
    const auto after = std::ranges::upper_bound(trajectory, time, {}, &TimedPlace::time);
    if (after == trajectory.begin())
        return trajectory.front().place;
    if (after == trajectory.end())
        return trajectory.back().place;
    const TimedPlace &a = *(after - 1), &b = *after;
    return a.place + (b.place - a.place) * ((time - a.time) / (b.time - a.time));
}

} // namespace haptics
