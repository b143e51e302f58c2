// A stroke in the making: turns pointer samples into what the editor records. A stroke keeps time from its
// own beginning. Never waits for the engine (ui/README 3). Interface's thread only.
#pragma once

#include "ui/interaction/brush_sizing.h"
#include "ui/interaction/clone_source.h"
#include "ui/interaction/pointer.h"
#include "ui/overlay/brush_cursor.h"

#include <QElapsedTimer>

namespace ui {

class StrokeInput {
  public:
    /// All outlive it.
    StrokeInput(Editor& editor, const Settings& settings, const ViewMotion& motion, const BrushSizing& sizing,
                const CloneSource& source);

    /// Begins at a contact with the chosen tool, or with the smoothing tool where Shift is held; Ctrl inverts. `input`
    /// numbers the pointer event, here and in `add` (Editor::addSample).
    void begin(const Pointer& pointer, const BrushContact& contact, std::uint64_t input);
    void add(const Pointer& pointer, std::uint64_t input);
    void end();
    /// As if the stroke had not been.
    void cancel();
    /// The contact at which the last stroke began.
    const base::Vec3d& start() const { return m_start; }

  private:
    Editor& m_editor;
    const Settings& m_settings;
    const ViewMotion& m_motion;
    const BrushSizing& m_sizing;
    const CloneSource& m_source;
    base::Vec3d m_start;
    QElapsedTimer m_clock;
};

} // namespace ui
