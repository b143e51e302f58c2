// A tracker with a force device at a VRPN server, over TCP alone [Taylor01]. After a cookie of 24 bytes either side
// sends messages: a header of six numbers of 32 bits (length of header and body, seconds, microseconds, sender, type,
// sequence) and a body padded to 8 bytes, all with the highest byte first. Senders and types are numbers that each side
// gives names to by messages of the types -1 and -2.
//
// We hear "vrpn_Tracker Pos_Quat" and "vrpn_Button Change" of the device's name, and say forces as a field that is the
// same everywhere, "vrpn_ForceDevice Force_Field".
#pragma once

#include "core/haptics/devices/line_device.h"

namespace haptics {

std::unique_ptr<Device> openVrpn(const DeviceSetup& setup);
/// `name`: the device's at its server.
std::unique_ptr<LineProtocol> makeVrpn(const std::string& name);

} // namespace haptics
