// What keeps a device from hurting whoever holds it, whatever the model says (haptics/README 5): forces ramp in, are
// limited in size and in how fast they change, and are zero at once where anything they rest on is missing.
#pragma once

#include "core/base/vec.h"

#include <limits>

namespace haptics {

struct SafetyLimits {
    static constexpr double none = std::numeric_limits<double>::infinity();
    double rampSeconds = 0.5; ///< from nothing to the whole force, after every interruption
    double mostForce = none;
    double mostSlew = none;       ///< change of force per second
    double stalePatch = 0.020;    ///< seconds; the model's side is silent
    double stalledDevice = 0.020; ///< seconds; the device's side is
    double mostJump = none;       ///< change of force in a tick beyond what the tool's way explains

    /// What a computed trajectory needs: it has no hand.
    static constexpr SafetyLimits off() { return {0, none, none, none, none}; }
};

/// Times in seconds of one clock.
struct Circumstances {
    double now = 0;
    double patch = 0;  ///< when the model's side last spoke
    double device = 0; ///< when the device last did
    bool focus = true; ///< the window has the keyboard, and Esc was not pressed
    /// What a force may change by as the tool has moved since the last tick: a few times stiffness times way.
    double explained = 0;
};

class Safety {
  public:
    explicit Safety(const SafetyLimits& limits) : m_limits(limits) {}

    /// What may be sent of a force. Once a tick.
    base::Vec3d pass(const base::Vec3d& force, const Circumstances& at);
    /// The last force was held back altogether.
    bool interrupted() const { return m_interrupted; }

  private:
    SafetyLimits m_limits;
    bool m_interrupted = true;
    double m_since = 0, m_last = 0; ///< when forces began, when the last tick was
    base::Vec3d m_sent;
};

} // namespace haptics
