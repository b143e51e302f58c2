// A haptic device, as the servo sees it: it tells where its end is and takes a force. One file per kind in devices/,
// one row in the table; nothing else knows a kind by name (haptics/README 7).
//
//     device.read(state)      every tick; false where nothing new has come since
//     device.send(force)      every tick; a device that can be felt acts on it until the next
//
// Device units are metres, newtons and seconds of the device's own frame; Workspace leads to the model. A device is
// used by one thread; one that has a thread of its own for its line hands over inside.
#pragma once

#include "core/haptics/trajectory.h"

#include <memory>
#include <span>
#include <string>

namespace haptics {

struct DeviceState {
    base::Vec3d position, velocity;
    unsigned buttons = 0; ///< a bit each
    double time = 0;      ///< seconds, of the device's own clock
};

/// What a device can do; infinite where nothing limits it.
struct DeviceLimits {
    double force;     ///< newtons
    double stiffness; ///< newtons per metre
    double mass;      ///< kilograms that a force accelerates at least
};

class Device {
  public:
    virtual ~Device() = default;
    /// The newest state; false where there is none since the last call, or none any more.
    virtual bool read(DeviceState& out) = 0;
    virtual void send(const base::Vec3d& force) = 0;
    /// There will be nothing new: a trajectory is over, a device was unplugged.
    virtual bool ended() const = 0;
    virtual DeviceLimits limits() const = 0;
};

/// What devices are opened with; each reads what concerns it.
struct DeviceSetup {
    Trajectory trajectory; ///< of simulated devices: the way of the hand
    std::string address;   ///< of those behind a line
};

struct DeviceRow {
    const char* id;
    const char* label;
    const char* tip;
    /// Throws base::Error where it cannot be reached.
    std::unique_ptr<Device> (*open)(const DeviceSetup& setup);
};

std::span<const DeviceRow> deviceTable();
/// Throws base::Error that lists those there are.
const DeviceRow& device(const std::string& id);

/// From a device's frame to the model's: x = centre + scale * position, and back for forces, so that what is felt does
/// not depend on the model's size.
struct Workspace {
    base::Vec3d centre;
    double scale = 1; ///< model units per metre

    base::Vec3d place(const base::Vec3d& position) const { return centre + position * scale; }
    base::Vec3d velocity(const base::Vec3d& v) const { return v * scale; }
    base::Vec3d force(const base::Vec3d& f) const { return f / scale; }
};

} // namespace haptics
