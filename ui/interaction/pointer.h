// Where the pointer is, with what it holds down: the same for mouse and pen. Plain value.
#pragma once

#include <QPointF>
#include <Qt>

namespace ui {

struct Pointer {
    QPointF pixel; ///< device pixels of the viewport
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    float pressure = 1;  ///< 0 to 1
    bool eraser = false; ///< the other end of a pen: the tool does the opposite, as with Ctrl

    /// The chosen tool does the opposite.
    bool inverts() const { return modifiers.testFlag(Qt::ControlModifier) != eraser; }
};

} // namespace ui
