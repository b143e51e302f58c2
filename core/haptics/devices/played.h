// A trajectory played back, place by place: whatever the force, it goes where it goes.
#pragma once

#include "core/haptics/device.h"

namespace haptics {

/// Throws base::Error for a trajectory without places, or whose times do not ascend (trajectory.h).
std::unique_ptr<Device> openPlayed(const DeviceSetup& setup);

} // namespace haptics
