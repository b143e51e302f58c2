// Where the pointer is, with what it holds down: the same for mouse and pen. Plain value.
#pragma once

#include <QPointF>
#include <Qt>

namespace ui {

struct Pointer {
    QPointF pixel; ///< device pixels of the viewport
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    float pressure = 1; ///< 0 to 1
};

} // namespace ui
