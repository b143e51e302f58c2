#include "core/haptics/passivity.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

/// The largest part, up to 1, with part * along + part^2 * own <= most. REQUIRES: own, most >= 0.
static double partWithin(double along, double own, double most) {
    if (along + own <= most)
        return 1;
    const double root = std::sqrt(along * along + 4 * own * most);
    return along > 0 ? 2 * most / (along + root) : (root - along) / (2 * own);
}

Vec3d Passivity::limit(const Vec3d& x, const Vec3d& force) {
    constexpr double share = 0.5; // of what is left: the hand may do as much to the way as the mass does
    Vec3d way = m_begun ? x - m_last : Vec3d{};
    if (m_begun) {
        m_work += dot(m_sent[0], way);
        std::rotate(m_sent.begin(), m_sent.begin() + 1, m_sent.begin() + static_cast<std::ptrdiff_t>(m_port.delay) + 1);
    }
    m_last = x;
    m_begun = true;

    // what is under way changes the ways to come, and is paid first
    const double longer = m_port.tick * m_port.tick / m_port.mass;
    double left = -m_work;
    for (std::size_t i = 0; i < m_port.delay; ++i) {
        way += m_sent[i] * longer;
        left -= std::max(0.0, dot(m_sent[i], way));
    }
    const Vec3d out = force * partWithin(dot(force, way), lengthSq(force) * longer, share * std::max(0.0, left));
    m_sent[m_port.delay] = out;
    return out;
}

} // namespace haptics
