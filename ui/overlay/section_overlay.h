// Section curves over the viewport, with Qt's painter.
#pragma once

#include "core/render/overlay/section_lines.h"

class QPainter;

namespace ui {

/// In device pixels of the camera's image, of that width. Nothing hides them but the other planes.
void paintSections(QPainter& painter, const render::SectionCurves& curves, const render::Camera& camera,
                   double widthPx);

} // namespace ui
