#include "core/base/error.h"
#include "core/haptics/devices/hand.h"
#include "core/haptics/devices/played.h"

#include <algorithm>

namespace haptics {

std::span<const DeviceRow> deviceTable() {
    static constexpr DeviceRow rows[] = {
        {"played", "Trajectory", "goes where a trajectory says and feels nothing", openPlayed},
        {"hand", "Simulated hand", "a mass that muscles pull along a trajectory and forces push off it", openHand},
    };
    return rows;
}

const DeviceRow& device(const std::string& id) {
    const auto rows = deviceTable();
    const auto found = std::ranges::find(rows, id, &DeviceRow::id);
    if (found != rows.end())
        return *found;
    std::string known;
    for (const DeviceRow& row : rows)
        known += std::string(known.empty() ? "" : ", ") + row.id;
    throw base::Error("there is no haptic device '" + id + "'", "", "the devices are " + known);
}

} // namespace haptics
