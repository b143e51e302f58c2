#include "core/haptics/servo.h"

#include <algorithm>
#include <chrono>

namespace haptics {

using base::Vec3d;

Servo::Servo(const ServoOptions& options)
    : m_options(options), m_proxy(options.tool, options.mostSteps), m_touch(options.touch), m_passivity(options.port),
      m_safety(options.safety) {}

void Servo::tune(const ServoOptions& options) {
    m_options.tool = options.tool;
    m_options.law = options.law;
    m_options.touch = options.touch;
    m_proxy.setTool(options.tool);
    m_touch.setLaw(options.touch);
}

Tick Servo::step(const PatchPtr& patch, const DeviceState& state, Circumstances at) {
    const auto begin = std::chrono::steady_clock::now();
    Tick out;
    out.time = state.time;
    out.tool = out.proxy = m_options.workspace.place(state.position);
    if (patch) {
        const surface::Surface& surface = patch->surface;
        if (!m_proxy.placed())
            m_proxy.place(surface, out.tool);
        else if (m_patch && m_patch != patch)
            m_proxy.follow(m_patch->surface, surface);
        m_proxy.move(surface, out.tool);
        out.proxy = m_proxy.position();
        out.contact = m_proxy.touches();
        const Vec3d velocity = m_options.workspace.velocity(state.velocity);
        out.force = forceOn(m_options.law, m_proxy, surface, out.tool, velocity);
        out.force = m_touch.step({at.now, out.tool, velocity, out.force, m_options.law.stiffness,
                                  m_options.workspace.scale, (state.buttons & holdButton) != 0},
                                 m_proxy, surface);
        out.touched = m_touch.now();
        m_patch = patch;
    }
    at.patch = patch ? patch->time : -SafetyLimits::none;
    // a surface that jumps, or changes under the tool, is to be felt as no blow
    constexpr double bend = 2; // a force turns about what is curved faster than the tool moves
    at.explained = bend * m_options.law.stiffness * (m_heard ? distance(state.position, m_place) : 0);
    m_place = state.position;
    out.sent = m_safety.pass(m_options.workspace.force(out.force), at);
    if (m_options.passive && patch) { // before that the device may not have told a place
        const double stiffness = m_options.law.stiffness, scale = m_options.workspace.scale;
        const double strain = std::max(distance(out.proxy, out.tool) / scale, length(out.sent) / stiffness);
        // a line tells its states when they come: two of them are as far apart as their times say
        const double seconds = m_heard ? state.time - m_told : 0;
        out.sent = m_heard && seconds == 0 ? m_passivity.hold(out.sent)
                                           : m_passivity.limit(state.position, out.sent, {stiffness, strain}, seconds);
        m_told = state.time;
    }
    m_heard = m_heard || patch;
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

} // namespace haptics
