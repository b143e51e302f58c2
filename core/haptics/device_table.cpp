#include "core/base/error.h"
#include "core/haptics/devices/hand.h"
#include "core/haptics/devices/inverse3.h"
#include "core/haptics/devices/mouse.h"
#include "core/haptics/devices/played.h"
#include "core/haptics/devices/space_mouse.h"
#include "core/haptics/devices/vrpn.h"

#include <algorithm>

namespace haptics {

std::span<const DeviceRow> deviceTable() {
    static constexpr DeviceRow rows[] = {
        {"played", "Trajectory", "goes where a trajectory says and feels nothing", DeviceKind::Simulated, false, "",
         openPlayed},
        {"hand", "Simulated hand", "a mass that muscles pull along a trajectory and forces push off it",
         DeviceKind::Simulated, true, "", openHand},
        {"mouse", "Mouse or pen", "over the picture, with the wheel or the pen's pressure for the depth",
         DeviceKind::Pointer, false, "", openMouse},
        {"space-mouse", "3D mouse", "at spacenavd, which speaks for 3Dconnexion's devices; /run/spnav.sock or as given",
         DeviceKind::Line, false, "/var/run/spnav.sock", openSpaceMouse},
        {"inverse3", "Haply Inverse3", "at the Haply Inverse service", DeviceKind::Line, true, "localhost:10001",
         openInverse3},
        {"vrpn", "VRPN", "a tracker with a force device at a VRPN server, NAME@HOST:PORT", DeviceKind::Line, true,
         "Phantom0@localhost:3883", openVrpn},
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

double viewedScale(const base::Box3f& bounds) {
    constexpr double reach = 0.2;
    const base::Vec3f size = bounds.hi - bounds.lo;
    const double most = static_cast<double>(std::max({size.x, size.y, size.z}));
    return most > 0 ? most / reach : 1;
}

} // namespace haptics
