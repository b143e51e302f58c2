#include "ui/interaction/cursor_tracker.h"

#include "ui/interaction/scene_pick.h"

#include <QWidget>

namespace ui {

CursorTracker::CursorTracker(const Editor& editor, const Settings& settings, const ViewMotion& motion,
                             const BrushSizing& sizing, QWidget& canvas)
    : m_editor(editor), m_settings(settings), m_motion(motion), m_sizing(sizing), m_canvas(canvas) {}

void CursorTracker::follow(const Pointer& pointer, bool shown) {
    const bool flip = pointer.inverts();
    m_cursor.pointer = pointer.pixel;
    m_cursor.inverted = m_settings.choice(m_settings.toolRow()).invert != flip;
    m_cursor.label = m_sizing.label();
    m_cursor.strength = m_sizing.draggedStrength();
    m_cursor.contact.reset();
    m_cursor.radiusPx = 0;
    if (shown) {
        m_cursor.contact = seenAt(m_editor.snapshot(), m_motion.camera(), pointer.pixel).contact;
        if (m_cursor.contact)
            m_cursor.radius = m_sizing.radiusAt(m_cursor.contact->position);
        else
            m_cursor.radiusPx = m_sizing.radiusPx();
    }
    m_canvas.update();
}

} // namespace ui
