#include "core/raycast/environment.h"

#include <algorithm>

namespace raycast {

using base::Vec3f;

/// 0 below a, 1 above b, smooth between.
static float step(float a, float b, float x) {
    const float t = std::clamp((x - a) / (b - a), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

static Vec3f mixed(const Vec3f& a, const Vec3f& b, float t) {
    return a * (1 - t) + b * t;
}

Environment::Environment(const Lighting& lighting, const Viewer& viewer)
    : m_viewer(viewer), m_up(normalized(viewer.up, viewer.upright)) {
    const LightRigRow& rig = lightRigRow(lighting.rig);
    m_above = rig.above, m_below = rig.below;
    if (!lighting.directions.empty()) {
        for (const Vec3f& d : lighting.directions)
            m_lamps.push_back(lampTowards(d, lighting.directions.size()));
        return;
    }
    // From straight above or below the lower edge of the image takes the place of the eye, as it does on the way there.
    const Vec3f level = m_up * dot(m_up, m_viewer.forward) - m_viewer.forward;
    const Vec3f edge = m_up * dot(m_up, m_viewer.upright) - m_viewer.upright;
    const Vec3f front = length(level) > 1e-3f ? normalized(level) : normalized(edge, base::perpendicular(m_up));
    const Vec3f right = cross(m_up, front);
    for (Lamp lamp : rig.lamps) {
        const Vec3f d = lamp.direction;
        lamp.direction = normalized(right * d.x + m_up * d.y + front * d.z);
        m_lamps.push_back(lamp);
    }
}

Vec3f Environment::background(const Vec3f& direction, float along) const {
    const float height = dot(direction, m_viewer.upright) / (std::max(along, 1e-3f) * m_viewer.slope);
    return mixed(m_viewer.top, m_viewer.bottom, step(-1, 1, -height));
}

Vec3f Environment::room(const Vec3f& n) const {
    return mixed(m_below, m_above, 0.5f + 0.5f * dot(n, m_up));
}

Vec3f Environment::from(const Vec3f& direction) const {
    // Walls are darker than floor and ceiling: glass and metal need something dark to show their form.
    constexpr float wall = 0.45f, behindFrom = 0.35f, behindTo = 0.85f, edge = 0.12f, most = 14;
    const float height = dot(direction, m_up), along = dot(direction, m_viewer.forward);
    const float up = step(-0.15f, 0.5f, height), level = 1 - step(0, 0.55f, std::abs(height));
    Vec3f out = mixed(m_below, m_above * 1.6f, up) * (1 - wall * level);
    const float behind = step(behindFrom, behindTo, along);
    if (behind > 0)
        out = mixed(out, background(direction, along), behind);
    for (const Lamp& lamp : m_lamps) {
        const float radius = std::max(lamp.radius, 0.05f), sine = std::sin(radius);
        const float angle = std::acos(std::clamp(dot(direction, lamp.direction), -1.0f, 1.0f));
        const float in = 1 - step(radius * (1 - edge), radius * (1 + edge), angle);
        const float bright = std::min(most, 1 / (sine * sine)); // a lamp of power p has the radiance p / sin^2 r
        out += lamp.power * (in * bright);
    }
    return out;
}

} // namespace raycast
