// A device behind a line: a thread of its own keeps the line, speaks the device's protocol on it and hands over by
// mailboxes, so that reading and sending never wait (haptics/README 7.2).
//
// The line is looked for again whenever it ends, so that a device may be plugged in, or its service started, later.
// Forces are zero when the servo has been silent for 20 ms, when the line begins, and when the device is let go.
#pragma once

#include "core/haptics/device.h"

#include <optional>

namespace haptics {

/// What is said on a line. Fed with whatever pieces the line brings; one that ends begins anew with a new object.
class LineProtocol {
  public:
    virtual ~LineProtocol() = default;
    /// The line is there: what is said first.
    virtual void begin(std::string& out) = 0;
    /// Takes what is whole from the front of `in`, answers, and tells the newest state. False where what came is not
    /// this protocol, or the other side says goodbye: the line is closed.
    virtual bool take(std::string& in, std::string& out, std::optional<DeviceState>& state) = 0;
    /// Says a force in newtons where it is time to; about once a millisecond.
    virtual void force(const base::Vec3d& newtons, std::string& out) = 0;
    /// The last words: a zero force.
    virtual void end(std::string& out) = 0;
};

/// Ticks: a state waits for the servo's tick, and its force for the line's.
constexpr std::size_t lineDelay = 2;

struct LineRow {
    std::unique_ptr<LineProtocol> (*make)(const std::string& name);
    DeviceLimits limits;
};

/// `address` may have a name in front, NAME@ADDRESS, which the protocol gets; one that begins with a slash is a path
/// and has none. Throws base::Error for what is no address.
std::unique_ptr<Device> openLineDevice(const std::string& address, const LineRow& row);

/// Of bytes that wait on either side; who sends or leaves more is no device.
constexpr std::size_t mostWaiting = 1 << 20;

} // namespace haptics
