// Section curves over the viewport, with Qt's painter.
#pragma once

#include "core/render/overlay/section_lines.h"

class QPainter;

namespace ui {

/// In device pixels of the image that the lines are of, of that width.
void paintSections(QPainter& painter, const render::LineRuns& lines, double widthPx);

} // namespace ui
