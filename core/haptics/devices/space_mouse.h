// A 3D mouse at spacenavd: its Unix socket sends eight numbers of 32 bits an event, in the machine's own order: the
// kind (0 motion, 1 button pressed, 2 released), then six axes and milliseconds since the last, or the button's number
//. It makes no force.
#pragma once

#include "core/haptics/devices/line_device.h"

namespace haptics {

std::unique_ptr<Device> openSpaceMouse(const DeviceSetup& setup);
std::unique_ptr<LineProtocol> makeSpaceMouse(const std::string& name);

} // namespace haptics
