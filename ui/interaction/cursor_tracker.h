// Keeps the brush's cursor where the pointer is: at the exact contact with the surface, or as a plain circle beside the
// model. Interface's thread only.
#pragma once

#include "ui/interaction/brush_sizing.h"
#include "ui/interaction/pointer.h"
#include "ui/overlay/brush_cursor.h"

namespace ui {

class CursorTracker {
  public:
    /// All outlive it.
    CursorTracker(const Editor& editor, const Settings& settings, const ViewMotion& motion, const BrushSizing& sizing,
                  QWidget& canvas);

    /// The pointer, the view or the model may be elsewhere; `shown`: the brush could work there now.
    void follow(const Pointer& pointer, bool shown);
    const BrushCursor& cursor() const { return m_cursor; }

  private:
    const Editor& m_editor;
    const Settings& m_settings;
    const ViewMotion& m_motion;
    const BrushSizing& m_sizing;
    QWidget& m_canvas;
    BrushCursor m_cursor;
};

} // namespace ui
