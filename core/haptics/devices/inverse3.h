// A Haply Inverse3 at its service: JSON over a WebSocket. The service begins with a list of devices and their states
// and sends the next state when the last was answered with a force: one answer each, in newtons.
//
//     in    {"inverse3":[{"device_id":ID,"state":{"cursor_position":{x,y,z},"cursor_velocity":{x,y,z}}}],
//            "wireless_verse_grip":[{"state":{"buttons":{"a":false,"b":false}}}]}
//     out   {"inverse3":[{"device_id":ID,"commands":{"set_cursor_force":{"vector":{x,y,z}}}}]}
//
// Services before 3.5 call the vector "values": give VALUES@HOST:PORT as their address. The device's x goes to the
// right, its y away from the person, its z up. Button a keeps hold, button b is the clutch.
#pragma once

#include "core/haptics/devices/line_device.h"

namespace haptics {

std::unique_ptr<Device> openInverse3(const DeviceSetup& setup);
/// `name`: "VALUES", or anything else.
std::unique_ptr<LineProtocol> makeInverse3(const std::string& name);

} // namespace haptics
