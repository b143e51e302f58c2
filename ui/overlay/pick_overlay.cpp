#include "ui/overlay/pick_overlay.h"

#include <QPainter>
#include <QPainterPath>

namespace ui {

void paintOutline(QPainter& painter, std::span<const QPointF> corners, bool rectangle, double pixelRatio) {
    if (corners.size() < 2)
        return;
    QPainterPath path;
    if (rectangle) {
        path.addRect(QRectF(corners.front(), corners.back()).normalized());
    } else {
        path.moveTo(corners.front());
        for (const QPointF& corner : corners.subspan(1))
            path.lineTo(corner);
        path.closeSubpath();
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(path, QColor(240, 150, 60, 36));
    painter.setPen(QPen(QColor(10, 10, 12, 190), 2.5 * pixelRatio));
    painter.drawPath(path);
    QPen dashes(QColor(255, 236, 214), 1.25 * pixelRatio);
    dashes.setDashPattern({4, 3});
    painter.setPen(dashes);
    painter.drawPath(path);
    painter.restore();
}

} // namespace ui
