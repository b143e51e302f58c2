#include "core/haptics/touch.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

/// Seconds from the contact's force to the clay's and back.
constexpr double change = 0.05;
/// A hand slower than this (metres per second) for so long rests.
constexpr double slow = 0.005, restSeconds = 0.15;

/// The foot that the tool is deepest in. REQUIRES: there is one.
static const Foot& deepest(const Proxy& proxy, const Vec3d& tool) {
    const auto feet = proxy.contacts().feet();
    return *std::ranges::min_element(feet, {}, [&](const Foot& foot) { return foot.height(tool); });
}

double Touch::roomAbove(const surface::Surface& surface, const Foot& foot) const {
    const Vec3d top = foot.position + foot.normal * m_law.above;
    const auto met = firstMet(surface, foot.position, top, std::span(&foot, 1));
    return met ? 0.5 * distance(met->position, foot.position) : m_law.above;
}

void Touch::begin(const TouchTick& at, const Proxy& proxy, const surface::Surface& surface) {
    m_now.phase = m_law.holds ? Touching::Holds : Touching::Works;
    ++m_now.stroke;
    m_begun = at.time;
    m_now.seconds = 0;
    const Foot& foot = deepest(proxy, at.tool);
    m_now.place = m_foot = foot.position;
    m_now.normal = foot.normal;
    m_now.room = roomAbove(surface, foot);
    m_from = m_clay = at.tool;
    m_resting = 0;
    m_pulled = false;
}

void Touch::work(const TouchTick& at, const Proxy& proxy, const surface::Surface& surface, double pressing) {
    const Foot& foot = deepest(proxy, at.tool);
    m_now.place = foot.position;
    m_now.normal = foot.normal;
    m_now.room = roomAbove(surface, foot);
    m_now.pressure = std::clamp((pressing - m_law.threshold) / std::max(m_law.full - m_law.threshold, 1e-9), 0.0, 1.0);
    m_now.seconds = at.time - m_begun;
}

/// The clay follows the tool as a damper lets it; the spring between them is what is felt.
void Touch::hold(const TouchTick& at, double seconds) {
    const double part =
        m_law.viscosity > 0 ? 1 - std::exp(-at.stiffness * seconds / m_law.viscosity) : 1.0; // exact for a held tool
    m_clay += (at.tool - m_clay) * part;
    m_pull = (m_clay - at.tool) * at.stiffness;
    m_now.place = m_foot + (m_clay - m_from);
    m_now.pressure = 1;
    m_now.seconds = at.time - m_begun;
    m_pulled = m_pulled || distance(m_clay, m_from) > m_law.slack;
    m_resting = length(at.velocity) < slow * at.scale ? m_resting + seconds : 0;
    const bool torn = length(m_pull) > m_law.tear * at.scale;
    if (torn || (!at.held && m_pulled && m_resting > restSeconds)) {
        m_now.phase = Touching::Hovers;
        m_pressed = true; // it takes hold again once it was let go
    }
}

void Touch::setLaw(const TouchLaw& law) {
    if (m_now.working() && (!law.works || law.holds != m_law.holds)) {
        m_now.phase = Touching::Hovers;
        m_pressed = true;
    }
    m_law = law;
}

Vec3d Touch::step(const TouchTick& at, const Proxy& proxy, const surface::Surface& surface) {
    const double seconds = m_first ? 0 : std::max(0.0, at.time - m_last);
    m_first = false;
    m_last = at.time;
    const bool touches = proxy.touches() && !proxy.contacts().empty();
    const double pressing = touches ? at.stiffness * proxy.depth() / at.scale : 0;
    const bool released = pressing < TouchLaw::release * m_law.threshold;
    m_pressed = m_pressed && !released;

    if (m_now.phase == Touching::Holds) {
        hold(at, seconds);
    } else if (m_now.phase == Touching::Works) {
        if (released)
            m_now.phase = Touching::Hovers;
        else
            work(at, proxy, surface, pressing);
    } else if (m_law.works && touches && !m_pressed && pressing >= m_law.threshold) {
        begin(at, proxy, surface);
        if (!m_law.holds)
            work(at, proxy, surface, pressing);
    }
    if (!m_now.working()) {
        m_now.phase = touches ? Touching::Hovers : Touching::Nothing;
        m_now.pressure = 0;
    }

    const double goal = m_now.phase == Touching::Holds ? 1 : 0;
    m_share += std::clamp(goal - m_share, -seconds / change, seconds / change);
    const Vec3d contact = m_now.phase == Touching::Works ? at.force - at.velocity * m_law.viscosity : at.force;
    return contact * (1 - m_share) + m_pull * m_share;
}

} // namespace haptics
