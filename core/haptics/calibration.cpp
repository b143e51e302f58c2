#include "core/haptics/calibration.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

static Vec3d leastOf(const Vec3d& a, const Vec3d& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

const Workspace& Calibration::step(const DeviceState& state, bool touches) {
    const Vec3d& x = state.position;
    const bool first = !m_last;
    if (first)
        m_least = m_most = x;
    m_least = leastOf(m_least, x);
    m_most = -leastOf(-m_most, -x);
    const Vec3d before = first ? x : *m_last, tool = m_workspace.place(before);
    m_last = x;
    const bool clutch = (state.buttons & clutchButton) != 0;
    if (m_next) { // about the tool; at first there is none yet
        m_workspace.scale = m_next->scale;
        m_workspace.turn = m_next->turn;
        m_workspace.centre = (m_frame && !first ? tool : m_next->middle) - m_workspace.velocity(before);
        m_frame = m_next;
        m_next.reset();
    }
    if (clutch) {
        m_workspace.centre += m_workspace.velocity(before - x);
    } else if (m_frame && !touches) {
        const Vec3d goal = m_frame->middle - m_workspace.velocity((m_least + m_most) * 0.5);
        const Vec3d way = goal - m_workspace.centre;
        const double most = drift * m_workspace.scale * distance(x, before), far = length(way);
        if (far > 0)
            m_workspace.centre += way * std::min(1.0, most / far);
    }
    return m_workspace;
}

} // namespace haptics
