// One tick of the servo: where the device is, in; the force that it shall make, out. The same function whether a thread
// calls it a thousand times a second (live.h) or the command line plays a trajectory (haptics/README 1).
//
//     device state -> Workspace -> Proxy on the newest Patch -> ForceLaw -> Touch -> Safety -> Passivity -> force
//
// Takes no locks and, once its scratch has grown, no memory. One thread at a time.
#pragma once

#include "core/haptics/device.h"
#include "core/haptics/force_law.h"
#include "core/haptics/passivity.h"
#include "core/haptics/patch.h"
#include "core/haptics/safety.h"
#include "core/haptics/touch.h"

namespace haptics {

struct ServoOptions {
    ToolShape tool;
    ForceLaw law;
    TouchLaw touch;
    SafetyLimits safety;
    bool passive = true;           ///< the passivity controller is on; without a hand there is nothing to control
    Port port;                     ///< of the device, as far as known
    int mostSteps = Proxy::timely; ///< of the proxy in a tick
    Workspace workspace;
};

/// What a tick found, in the model's frame.
struct Tick {
    double time = 0;         ///< the device's
    base::Vec3d tool, proxy; ///< centres
    base::Vec3d force;       ///< of the law and of clay, in units of stiffness times length
    bool contact = false;
    Touched touched;    ///< what the tool does to the model
    base::Vec3d sent;   ///< to the device, in its own units and frame
    double seconds = 0; ///< the step took
};

class Servo {
  public:
    explicit Servo(const ServoOptions& options);

    /// `patch` may be null: nothing to feel. `at.device` and `at.patch` need not be set.
    Tick step(const PatchPtr& patch, const DeviceState& state, Circumstances at);
    const ServoOptions& options() const { return m_options; }
    const Passivity& passivity() const { return m_passivity; }
    const Proxy& proxy() const { return m_proxy; }
    /// Another workspace from the next tick on.
    void setWorkspace(const Workspace& workspace) { m_options.workspace = workspace; }
    /// Another tool and other laws from the next tick on; all else stays.
    void tune(const ServoOptions& options);

  private:
    ServoOptions m_options;
    Proxy m_proxy;
    Touch m_touch;
    Passivity m_passivity;
    Safety m_safety;
    PatchPtr m_patch;  ///< of the last tick
    double m_told = 0; ///< the time of the device's last state
    base::Vec3d m_place;
    bool m_heard = false;
};

} // namespace haptics
