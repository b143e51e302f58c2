// A hand that holds a device, simulated: a mass that muscles pull along a trajectory and forces push off it. It closes
// the loop from force to motion, and so shows what a trajectory cannot: whether contact is stable (haptics/README 7.1).
#pragma once

#include "core/haptics/device.h"

namespace haptics {

/// A finger on a device, at the order of what is measured of people [Colgate97].
struct HandModel {
    double mass = 0.1;     ///< kilograms, with the device's
    double muscle = 300;   ///< newtons per metre towards where the hand wants to be
    double damping = 4;    ///< newton seconds per metre
    double tick = 0.001;   ///< seconds between two states
    std::size_t delay = 0; ///< ticks until a force acts
    double settling = 0;   ///< seconds after the trajectory's end until it ends
};

/// Of the default model.
std::unique_ptr<Device> openHand(const DeviceSetup& setup);
std::unique_ptr<Device> makeHand(const Trajectory& trajectory, const HandModel& model);

} // namespace haptics
