#include "ui/overlay/placement_overlay.h"

#include "ui/theme/theme.h"

#include <QPainter>
#include <QPolygonF>

namespace ui {

static QColor colourOf(const Handle& handle) {
    const bool plain = handle.kind == Handle::Kind::Free || handle.kind == Handle::Kind::Scale;
    return plain ? QColor(240, 240, 240) : axisColour(handle.axis);
}

static void paintHead(QPainter& painter, const QPointF& from, const QPointF& to, double size) {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1)
        return;
    const QPointF along = way * (size / length), across(-0.5 * along.y(), 0.5 * along.x());
    const QPointF corners[] = {to + along, to + across, to - across};
    painter.drawConvexPolygon(corners, 3);
}

static void paintShape(QPainter& painter, const Handle& handle, const QPolygonF& line, double pixelRatio) {
    const double size = 6 * pixelRatio;
    if (handle.kind == Handle::Kind::Free)
        painter.drawEllipse(line.front(), size, size);
    else if (handle.kind == Handle::Kind::Scale)
        painter.drawRect(QRectF(line.front() - QPointF(size, size), 2 * QSizeF(size, size)));
    else {
        painter.drawPolyline(line);
        if (handle.kind == Handle::Kind::Move)
            paintHead(painter, line.front(), line.back(), 2.4 * size);
    }
}

void paintHandles(QPainter& painter, std::span<const HandleShape> shapes, const std::optional<Handle>& bright,
                  const render::Camera& camera, double pixelRatio) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const HandleShape& shape : shapes) {
        QPolygonF line;
        for (const base::Vec3d& each : shape.line)
            if (const base::Vec3d at = camera.project(each); at.z > 0)
                line << QPointF(at.x, at.y);
        if (line.isEmpty())
            continue;
        const bool lit = bright == shape.handle;
        const QColor colour = lit ? QColor(255, 222, 120) : colourOf(shape.handle);
        const double width = (lit ? 3.4 : 2.2) * pixelRatio;
        for (const auto& [pen, wide] : {std::pair(QColor(0, 0, 0, 140), width + 2 * pixelRatio), {colour, width}}) {
            painter.setPen(QPen(pen, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.setBrush(shape.handle.kind == Handle::Kind::Turn ? QBrush(Qt::NoBrush) : QBrush(colour));
            paintShape(painter, shape.handle, line, pixelRatio);
        }
    }
    painter.restore();
}

} // namespace ui
