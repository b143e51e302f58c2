// Annotations by a window's painter, with the window's own font.
#pragma once

#include "core/render/overlay/annotations.h"

class QPainter;

namespace ui {

/// In the coordinates of the drawing: device pixels.
void paint(QPainter& painter, const render::Drawing& drawing);

} // namespace ui
