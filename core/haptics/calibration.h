// How a device's reach lies over what is seen: turned and scaled with the view, moved by the clutch, and drifting back
// to its middle, so slowly that nobody notices [Conti05] (haptics/README 7.4).
//
// Nothing but the hand ever moves the tool while it touches: another view turns the workspace about the tool.
#pragma once

#include "core/haptics/device.h"

#include <optional>

namespace haptics {

/// Where a person looks from.
struct ViewFrame {
    base::Vec3d middle;                         ///< where the middle of the device's reach is to be
    base::Mat3d turn = base::Mat3d::identity(); ///< columns: the view's right, up, towards the viewer
    double scale = 1;                           ///< model units per metre
};

class Calibration {
  public:
    /// Of the hand's own way: as much may the workspace drift.
    static constexpr double drift = 0.1;

    explicit Calibration(const Workspace& workspace = {}) : m_workspace(workspace) {}

    void look(const ViewFrame& frame) { m_next = frame; }
    /// Once a tick with a new state; `touches`: the tool is in contact.
    const Workspace& step(const DeviceState& state, bool touches);
    const Workspace& workspace() const { return m_workspace; }

  private:
    Workspace m_workspace;
    std::optional<ViewFrame> m_frame, m_next;
    std::optional<base::Vec3d> m_last; ///< the device's position
    base::Vec3d m_least, m_most;       ///< of its positions so far: their middle is that of its reach
};

} // namespace haptics
