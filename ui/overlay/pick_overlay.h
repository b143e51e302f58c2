// The outline that a person is drawing over the picture, with Qt's painter: marching ants that are seen on anything.
#pragma once

#include <QPointF>
#include <span>

class QPainter;

namespace ui {

/// Device pixels; closed from the last corner to the first. Of a rectangle two opposite corners.
void paintOutline(QPainter& painter, std::span<const QPointF> corners, bool rectangle, double pixelRatio);

} // namespace ui
