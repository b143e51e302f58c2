#include "core/haptics/passivity.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

namespace {

constexpr double again = 3;    ///< a hand may do so much more than what it did
constexpr double memory = 0.5; ///< seconds until a third of that is left

constexpr double silence = 20; ///< ticks: after that long places have nothing to do with the last

/// What a force can do at most: part * along + part^2 * own + turns * |part * force - before|. Convex in the part.
struct Cost {
    Vec3d force, before;
    double along, own, turns;

    double of(double part) const { return part * (along + part * own) + turns * length(force * part - before); }

    /// The largest part, up to 1, that costs no more than `most`; 0 where none does.
    double partWithin(double most) const {
        if (of(1) <= most)
            return 1;
        double enough = 0, tooMuch = 1;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (enough + tooMuch);
            (of(middle) <= most ? enough : tooMuch) = middle;
        }
        return enough;
    }
};

} // namespace

/// How far a way so many ticks ahead may be from what the last one and the forces tell of it, and what wrong places do
/// to both.
double Passivity::slack(std::size_t ticks) const {
    const double change = std::max(m_port.acceleration * m_port.tick * m_port.tick, again * m_shake);
    return static_cast<double>(ticks) * change + 5 * m_port.resolution;
}

/// A tick is over, or several: the force that acted has done its work along a way.
void Passivity::observe(const Vec3d& way, double ticks) {
    const Vec3d speed = way / ticks, expected = m_way + (m_acted + m_sent[0]) * half();
    const double unexpected = distance(speed, expected);
    m_shake = std::max(unexpected, m_shake * std::exp(-ticks * m_port.tick / memory));
    m_way = speed;
    const double done = dot(m_sent[0], way);
    m_work += done;
    // by parts, the work of errors e is the sum of e times the changes of the force
    m_left -= done + m_port.resolution * distance(m_sent[0], m_acted);
    m_acted = m_sent[0];
    std::rotate(m_sent.begin(), m_sent.begin() + 1, m_sent.begin() + static_cast<std::ptrdiff_t>(m_port.delay) + 1);
}

Vec3d Passivity::limit(const Vec3d& x, const Vec3d& force, const Spring& spring, double seconds) {
    const double ticks = seconds > 0 ? std::max(seconds / m_port.tick, 0.25) : 1.0;
    if (m_begun && ticks <= silence)
        observe(x - m_last, ticks);
    else // it was away, and safety let go of it
        m_sent = {}, m_acted = m_way = {};
    m_last = x;
    m_begun = true;
    if ((m_waited += ticks * m_port.tick) >= almsSeconds) {
        m_waited = 0;
        m_left = std::max(m_left, alms);
    }
    if (spring.stiffness > 0) { // what friction and damping took for good shall not feed an oscillation later
        const double reach = spring.length + 2 * slack(m_port.delay + 1);
        m_left = std::min(m_left, 0.5 * spring.stiffness * reach * reach);
    }

    // what is under way is paid first, and changes the ways to come
    Vec3d way = m_way;
    double left = m_left;
    Vec3d before = m_acted;
    for (std::size_t i = 0; i < m_port.delay; ++i) {
        way += (before + m_sent[i]) * half();
        left -=
            dot(m_sent[i], way) + length(m_sent[i]) * slack(i + 1) + m_port.resolution * distance(m_sent[i], before);
        before = m_sent[i];
    }
    way += before * half();
    const Cost cost{force, before, dot(force, way) + length(force) * slack(m_port.delay + 1), lengthSq(force) * half(),
                    m_port.resolution};
    const Vec3d out = force * cost.partWithin(left);
    m_sent[m_port.delay] = out;
    return out;
}

Vec3d Passivity::hold(const Vec3d& force) {
    Vec3d& last = m_sent[m_port.delay];
    const double most = length(force), now = length(last);
    if (now > most)
        last *= most / now;
    return last;
}

} // namespace haptics
