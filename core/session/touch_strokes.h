// What a tool that is felt does to the model, as strokes: the same as those of a pointer, recorded as such, so that
// they replay without a device (session/README 3.3).
//
//     TouchStrokes strokes(context, settings);
//     for each tick: if (strokes.step(tick)) show(strokes.surface());
//     strokes.end();                             a stroke that goes on ends
//     strokes.lines()                            the session lines of those that met the model
//
// Each stroke becomes a step of history when it ends. Nothing is journalled here. The document stays as it is
// meanwhile.
#pragma once

#include "core/haptics/servo.h"
#include "core/session/live_stroke.h"

namespace session {

/// How the clay is worked with a tool of these settings.
haptics::TouchLaw touchLawOf(const sculpt::StrokeSettings& settings, haptics::TouchLaw law);
/// A sample where the tool works. REQUIRES: touched.working().
sculpt::StrokeSample sampleOf(const haptics::Touched& touched);

class TouchStrokes {
  public:
    /// As LiveStroke: throws base::Error for settings out of range, and where no model is open.
    TouchStrokes(Context& context, sculpt::StrokeSettings settings);
    ~TouchStrokes();

    /// Returns true where `surface()` is another version.
    bool step(const haptics::Tick& tick);
    /// The same.
    bool end();
    surface::Surface surface() const; ///< what is shown of the model
    const std::vector<nlohmann::json>& lines() const { return m_lines; }
    std::size_t samples() const { return m_samples; }

  private:
    Context& m_context;
    Context m_quiet; ///< without a journal
    sculpt::StrokeSettings m_settings;
    std::optional<LiveStroke> m_live;
    std::uint64_t m_stroke = 0;
    double m_last = 0; ///< seconds of the last sample in its stroke
    std::vector<nlohmann::json> m_lines;
    std::size_t m_samples = 0;
};

} // namespace session
