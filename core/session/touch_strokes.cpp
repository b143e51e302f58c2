#include "core/session/touch_strokes.h"

#include "core/selection/hidden.h"

#include <nlohmann/json.hpp>

namespace session {

/// Seconds between two samples: as often as a pen tells.
constexpr double sampleEvery = 0.008;

haptics::TouchLaw touchLawOf(const sculpt::StrokeSettings& settings, haptics::TouchLaw law) {
    const auto radius = static_cast<double>(settings.radius);
    law.works = true;
    law.holds = sculpt::holds(sculpt::tool(settings.tool));
    law.slack = 0.1 * radius;
    law.above = 0.5 * radius;
    return law;
}

sculpt::StrokeSample sampleOf(const haptics::Touched& touched) {
    const base::Vec3d from = touched.place + touched.normal * touched.room;
    sculpt::StrokeSample out;
    out.ray = {base::cast<float>(from), base::cast<float>(-touched.normal)};
    out.pressure = static_cast<float>(touched.pressure);
    out.seconds = static_cast<float>(touched.seconds);
    out.reach = touched.phase == haptics::Touching::Holds ? static_cast<float>(touched.room) : 0;
    return out;
}

TouchStrokes::TouchStrokes(Context& context, sculpt::StrokeSettings settings)
    : m_context(context), m_quiet{context.document, context.folder, context.progress, {}, 0, {}, nullptr},
      m_settings(std::move(settings)) {
    LiveStroke(m_quiet, m_settings); // throws now, not when it is first pressed
}

TouchStrokes::~TouchStrokes() = default;

surface::Surface TouchStrokes::surface() const {
    return m_live ? m_live->surface() : selection::shownOf(m_context.document.surface());
}

bool TouchStrokes::step(const haptics::Tick& tick) {
    const haptics::Touched& touched = tick.touched;
    bool changed = false;
    if (m_live && (!touched.working() || touched.stroke != m_stroke))
        changed = end();
    if (!touched.working())
        return changed;
    if (!m_live) {
        m_live.emplace(m_quiet, m_settings);
        m_stroke = touched.stroke;
    } else if (touched.seconds < m_last + sampleEvery) {
        return changed;
    }
    m_last = touched.seconds;
    ++m_samples;
    return m_live->add(sampleOf(touched)) || changed;
}

bool TouchStrokes::end() {
    if (!m_live)
        return false;
    const bool met = m_live->finish();
    if (met)
        m_lines.push_back(m_live->line());
    m_live.reset();
    m_context.dabs += m_quiet.dabs;
    m_context.dabSeconds.insert(m_context.dabSeconds.end(), m_quiet.dabSeconds.begin(), m_quiet.dabSeconds.end());
    m_quiet.dabs = 0;
    m_quiet.dabSeconds.clear();
    return true;
}

} // namespace session
