#include "ui/overlay/touch_overlay.h"

#include <algorithm>
#include <cmath>
#include <QPainter>
#include <QPainterPath>

namespace ui {

using base::Vec3d;

namespace {

constexpr double pixelsPerNewton = 22, longest = 110, smallest = 4;

void outline(QPainter& painter, const QPainterPath& path, const QColor& colour, double width) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

/// As long as the force, in the direction in which it is seen.
void paintArrow(QPainter& painter, const QPointF& from, const Vec3d& force, const render::Camera& camera,
                double pixelRatio) {
    const QPointF seen(dot(force, camera.right()), -dot(force, camera.upright()));
    const double size = std::hypot(seen.x(), seen.y()), newtons = length(force);
    if (!(newtons > 0.02) || !(size > 0))
        return;
    const double scale = std::min(pixelsPerNewton, longest / newtons) * pixelRatio;
    const QPointF to = from + seen * scale, along = seen / size, across(-along.y(), along.x());
    QPainterPath path(from);
    path.lineTo(to);
    const double head = std::min(7 * pixelRatio, 0.5 * size * scale);
    path.moveTo(to - along * head + across * head * 0.6);
    path.lineTo(to);
    path.lineTo(to - along * head - across * head * 0.6);
    outline(painter, path, QColor(255, 120, 70), 2 * pixelRatio);
}

} // namespace

void paint(QPainter& painter, const TouchLook& look, const render::Camera& camera, double pixelRatio) {
    const Vec3d tool = camera.project(look.tool), proxy = camera.project(look.proxy);
    if (!look.shown || !(tool.z > 0) || !(proxy.z > 0))
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = std::max(look.radius * camera.pixelsPerUnit(proxy.z), smallest * pixelRatio);
    const QPointF at(proxy.x, proxy.y), hand(tool.x, tool.y);
    const QColor colour = look.works     ? QColor(255, 190, 90)
                          : look.contact ? QColor(150, 220, 255)
                                         : QColor(200, 205, 210);
    painter.setPen(QPen(QColor(255, 255, 255, 120), pixelRatio, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(hand, radius, radius);
    painter.drawLine(at, hand);
    QRadialGradient ball(at - QPointF(0.35 * radius, 0.4 * radius), 1.5 * radius);
    ball.setColorAt(0, colour.lighter(125));
    ball.setColorAt(1, colour.darker(190));
    painter.setPen(QPen(QColor(0, 0, 0, 150), pixelRatio));
    painter.setBrush(ball);
    painter.drawEllipse(at, radius, radius);
    painter.setBrush(Qt::NoBrush);
    paintArrow(painter, at, look.force, camera, pixelRatio);
    painter.restore();
}

} // namespace ui
