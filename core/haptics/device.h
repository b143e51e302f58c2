// A haptic device, as the servo sees it: it tells where its end is and takes a force. One file per kind in devices/,
// one row in the table; nothing else knows a kind by name (haptics/README 7).
//
//     device.read(state)      every tick; false where nothing new has come since
//     device.send(force)      every tick; a device that can be felt acts on it until the next
//
// Device units are metres, newtons and seconds of the device's own frame; Workspace leads to the model. A device is
// used by one thread; one that has a thread of its own for its line hands over inside.
#pragma once

#include "core/base/box.h"
#include "core/base/mat3.h"
#include "core/haptics/mailbox.h"
#include "core/haptics/trajectory.h"

#include <memory>
#include <span>
#include <string>

namespace haptics {

/// Buttons by what they are for: keep hold of clay, move the device without the tool.
constexpr unsigned holdButton = 1, clutchButton = 2;

struct DeviceState {
    base::Vec3d position, velocity;
    unsigned buttons = 0;     ///< a bit each
    double time = 0;          ///< seconds, of the device's own clock
    base::Vec3d turning = {}; ///< radians a second, of devices that turn: the view follows
};

/// What a device can do; infinite where nothing limits it.
struct DeviceLimits {
    double force;          ///< newtons
    double stiffness;      ///< newtons per metre
    double mass;           ///< kilograms that a force accelerates at least
    std::size_t delay = 0; ///< ticks from a force that is sent until it acts
};

class Device {
  public:
    virtual ~Device() = default;
    /// The newest state; false where there is none since the last call, or none any more.
    virtual bool read(DeviceState& out) = 0;
    virtual void send(const base::Vec3d& force) = 0;
    /// There will be nothing new: a trajectory is over, a device was unplugged.
    virtual bool ended() const = 0;
    /// Something has been heard of it: what is behind a line may come and go.
    virtual bool connected() const { return true; }
    virtual DeviceLimits limits() const = 0;
};

/// What devices are opened with; each reads what concerns it.
struct DeviceSetup {
    Trajectory trajectory;                              ///< of simulated devices: the way of the hand
    std::string address;                                ///< of those behind a line; empty: the row's
    std::shared_ptr<Mailbox<DeviceState>> pointer = {}; ///< of those that the window hears of: read by the device alone
};

enum class DeviceKind {
    Simulated, ///< goes along DeviceSetup::trajectory
    Pointer,   ///< is told of by the window
    Line       ///< is at an address
};

struct DeviceRow {
    const char* id;
    const char* label;
    const char* tip;
    DeviceKind kind;
    bool felt;           ///< it makes forces; others show them
    const char* address; ///< where it usually is, of DeviceKind::Line
    /// Throws base::Error where it cannot be reached.
    std::unique_ptr<Device> (*open)(const DeviceSetup& setup);
};

std::span<const DeviceRow> deviceTable();
/// Throws base::Error that lists those there are.
const DeviceRow& device(const std::string& id);

/// From a device's frame to the model's: x = centre + scale * turn * position, and back for forces, so that what is
/// felt does not depend on the model's size.
struct Workspace {
    base::Vec3d centre;
    double scale = 1;                           ///< model units per metre
    base::Mat3d turn = base::Mat3d::identity(); ///< a rotation: to the view's right, up and towards the viewer

    base::Vec3d place(const base::Vec3d& position) const { return centre + velocity(position); }
    base::Vec3d velocity(const base::Vec3d& v) const { return turn * v * scale; }
    base::Vec3d force(const base::Vec3d& f) const { return transposed(turn) * f / scale; }
    base::Vec3d position(const base::Vec3d& place) const { return transposed(turn) * (place - centre) / scale; }
};

/// At which a model of these bounds is as large as what a wrist reaches, 20 cm.
double viewedScale(const base::Box3f& bounds);

} // namespace haptics
