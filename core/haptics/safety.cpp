#include "core/haptics/safety.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

static Vec3d shortened(const Vec3d& v, double most) {
    const double l = length(v);
    return l > most ? v * (most / l) : v;
}

Vec3d Safety::pass(const Vec3d& force, const Circumstances& at) {
    const bool fit = at.focus && at.now - at.patch <= m_limits.stalePatch &&
                     at.now - at.device <= m_limits.stalledDevice && isFinite(force);
    if (fit && m_interrupted)
        m_since = m_last = at.now;
    m_interrupted = !fit;
    if (!fit)
        return m_sent = {};
    const double ramp = m_limits.rampSeconds > 0 ? std::clamp((at.now - m_since) / m_limits.rampSeconds, 0.0, 1.0) : 1;
    const Vec3d wanted = shortened(force * ramp, m_limits.mostForce);
    double most = m_limits.mostJump + at.explained;
    if (m_limits.mostSlew < SafetyLimits::none)
        most = std::min(most, m_limits.mostSlew * std::max(0.0, at.now - m_last));
    m_sent = most < SafetyLimits::none ? m_sent + shortened(wanted - m_sent, most) : wanted;
    m_last = at.now;
    return m_sent;
}

} // namespace haptics
