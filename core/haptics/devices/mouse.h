// A mouse or a pen, as the window tells of it: its place over the picture, and the wheel or the pen's pressure for the
// depth. It makes no force; the window shows one, and the ball that stays behind the pointer.
#pragma once

#include "core/haptics/device.h"

namespace haptics {

/// Throws base::Error without DeviceSetup::pointer.
std::unique_ptr<Device> openMouse(const DeviceSetup& setup);

} // namespace haptics
