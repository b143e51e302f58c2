// Passivity observer and controller in the time domain [Hannaford02]: what a sampled spring would give to the hand
// beyond what the hand has put in is taken from the force before it acts (haptics/README 4).
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cstddef>
#include <limits>

namespace haptics {

struct Port {
    std::size_t delay = 0; ///< ticks from when a force is computed until it acts, for one tick
    /// The least mass that forces accelerate, the device's and the hand's: kilograms where forces are newtons.
    double mass = std::numeric_limits<double>::infinity();
    double tick = 0.001; ///< seconds
};

class Passivity {
  public:
    static constexpr std::size_t mostDelay = 8;

    /// REQUIRES: port.delay <= mostDelay.
    explicit Passivity(const Port& port = {}) : m_port(port) {}

    /// Of the force computed for a tool at x, what may be sent. Called once a tick, in order.
    base::Vec3d limit(const base::Vec3d& x, const base::Vec3d& force);
    /// Work done on the hand so far, by the forces sent: not above zero, unless the hand itself more than doubles its
    /// speed in a tick.
    double workOnHand() const { return m_work; }

  private:
    Port m_port;
    std::array<base::Vec3d, mostDelay + 1> m_sent{}; ///< the one that acts first comes first
    bool m_begun = false;
    base::Vec3d m_last;
    double m_work = 0;
};

} // namespace haptics
