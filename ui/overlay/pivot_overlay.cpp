#include "ui/overlay/pivot_overlay.h"

#include <QPainter>

namespace ui {

void paintPivot(QPainter& painter, const base::Vec3d& place, const render::Camera& camera, bool turning) {
    const base::Vec3d at = camera.project(place);
    if (!(at.z > 0))
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const int alpha = turning ? 230 : 110;
    const QPointF middle(at.x, at.y);
    painter.setPen(QPen(QColor(0, 0, 0, alpha / 2), 3));
    painter.drawEllipse(middle, 6, 6);
    painter.setPen(QPen(QColor(255, 205, 130, alpha), 1.4));
    painter.drawEllipse(middle, 6, 6);
    painter.setBrush(QColor(255, 205, 130, alpha));
    painter.drawEllipse(middle, 1, 1);
    painter.restore();
}

} // namespace ui
